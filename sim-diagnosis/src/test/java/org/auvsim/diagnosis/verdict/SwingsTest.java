package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.effect.PeriodicForce;
import org.auvsim.core.effect.WaveForce;
import org.auvsim.core.field.OscillatingCurrent;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.model.Partings;
import org.auvsim.diagnosis.model.Partings.Leg;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.subject.MeasuredVehicle;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

/** Many variants that swing part from the model as each of them does alone. */
class SwingsTest {
    private static final int MANY = 16;
    private static final double SHARE = 0.02;

    private static BelievedModel model;
    private static MeasuredRun run;
    private static RigidMotion[] motion;

    @BeforeAll
    static void aVehicleIsMeasured() throws Exception {
        model = MeasuredVehicle.model(0.025);
        run = MeasuredVehicle.run(model);
        RigidMotion start =
                new RigidMotion(
                        new Vec3(0.4, -0.3, 0.2),
                        new Quat(0.96, 0.1, -0.15, 0.2).normalized(),
                        new Vec3(0.5, -0.2, 0.1),
                        new Vec3(0.1, -0.2, 0.2));
        Entrant believed = new Entrant(model.variant(), start);
        motion = Ensemble.simulate(model, run, 0, run.size() - 1, List.of(believed))[0];
    }

    private static List<Leg> legs(int samples) {
        List<Leg> legs = new ArrayList<>();
        for (int k = 0; k + samples < motion.length; k += samples) {
            legs.add(new Leg(k, k + samples, motion[k], motion[k + samples]));
        }
        return legs;
    }

    private static double[][][] partings(List<Leg> legs, List<Variant> variants) {
        return Partings.of(model, run, legs, model.variant(), variants);
    }

    /** At 0.5 to 8 rad/s. */
    private static double omega(int i) {
        return 0.5 * (i + 1);
    }

    private static Variant inCurrent(int i) {
        Vec3 swing = new Vec3(1e-4, -2e-4, 5e-5);
        double period = 2 * Math.PI / omega(i);
        return model.variant()
                .in(new OscillatingCurrent(1, "swing", Vec3.ZERO, swing, period, 0.3 * i));
    }

    private static Variant pushed(int i) {
        PeriodicForce force =
                new PeriodicForce(new Vec3(0.01, 0, 0.02), new Vec3(0, 0.01, 0), omega(i));
        return model.variant().with(b -> b.effect(force));
    }

    private static Variant inWaves(int i) {
        double waveNumber = omega(i) * omega(i) / 9.81;
        WaveForce force = new WaveForce(0.01, 0.4, omega(i), 0.2 * i, waveNumber);
        return model.variant().with(b -> b.effect(force));
    }

    private static List<Variant> many(IntFunction<Variant> variant) {
        return IntStream.range(0, MANY).mapToObj(variant).toList();
    }

    /** By leg: each variant among many, and alone. */
    private static void assertAlike(List<Variant> variants, int samples, double share) {
        List<Leg> legs = legs(samples);
        double[][][] together = partings(legs, variants);
        for (int i = 0; i < variants.size(); i++) {
            double[][] alone = partings(legs, List.of(variants.get(i)))[0];
            double[] squares = new double[RigidMotion.SIZE];
            double[] off = new double[RigidMotion.SIZE];
            for (int l = 0; l < alone.length; l++) {
                for (int k = 0; k < RigidMotion.SIZE; k++) {
                    squares[k] += alone[l][k] * alone[l][k];
                    double difference = together[i][l][k] - alone[l][k];
                    off[k] += difference * difference;
                }
            }
            for (int k = 0; k < RigidMotion.SIZE; k++) {
                assertThat(Math.sqrt(off[k]))
                        .as("number %s of variant %s", k, i)
                        .isLessThanOrEqualTo(share * Math.sqrt(squares[k]));
            }
        }
    }

    @Test
    void currentsForcesAndWavesOfManyFrequenciesPartAsEachDoesAlone() {
        assertAlike(many(SwingsTest::inCurrent), 4, SHARE);
        assertAlike(many(SwingsTest::pushed), 4, SHARE);
        assertAlike(many(SwingsTest::inWaves), 4, SHARE);
    }

    @Test
    void inLongerLegsEachIsSimulated() {
        assertAlike(many(SwingsTest::inCurrent), 8, 0);
    }

    @Test
    void whatIsMoreThanASwingIsSimulated() {
        List<Variant> heavier =
                many(SwingsTest::pushed).stream().map(v -> v.with(b -> b.mass(12.01))).toList();

        assertAlike(heavier, 4, 0);
    }
}
