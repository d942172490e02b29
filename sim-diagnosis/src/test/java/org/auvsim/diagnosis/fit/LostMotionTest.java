package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.MagnusForce;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Ensemble.Commands;
import org.auvsim.diagnosis.model.Partings.Leg;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.shooting.LegResponse;
import org.auvsim.diagnosis.shooting.Shooting;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.diagnosis.shooting.WindowDerivatives;
import org.auvsim.diagnosis.shooting.WindowDerivatives.Moves;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.diagnosis.subject.MeasuredVehicle;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.Arrays;
import java.util.List;

/** A hypothesis whose motions cannot be simulated is a bad one, and nothing worse. */
class LostMotionTest {
    /** Drag that is too stiff for any step. */
    private record Stuck() implements Cause {
        @Override
        public String id() {
            return "stuck";
        }

        @Override
        public List<Parameter> parameters() {
            return List.of();
        }

        @Override
        public Variant in(Variant model, double[] theta) {
            Vec3 all = new Vec3(1e9, 1e9, 1e9);
            return model.with(b -> b.effect(new Damping(all, Vec3.ZERO, Vec3.ZERO, Vec3.ZERO)));
        }
    }

    @Test
    void windowsFollowNothingAndCostWithoutEnd() throws Exception {
        BelievedModel model = MeasuredVehicle.model(0.025);
        List<MeasuredRun> runs = List.of(MeasuredVehicle.run(model));
        Noise noise = Noise.of(runs);
        Hypothesis stuck = Hypothesis.NONE.and(new Stuck(), new double[0]);

        Fit fit = Following.of(Stepping.exact(model), stuck, Misses.of(runs, noise), noise);

        assertThat(fit.windows().getFirst()).hasSizeGreaterThan(1);
        assertThat(Refinement.approach(fit, 1).cost()).isInfinite();
    }

    @Test
    void neighboursOfALostMotionAreLost() throws Exception {
        BelievedModel model = MeasuredVehicle.model(0.025);
        Variant stuck = new Stuck().in(model.variant(), new double[0]);

        RigidMotion[][] told = neighbours(model, List.of(stuck, model.variant()));

        assertThat(told[0]).containsOnly(Ensemble.LOST);
        assertThat(told[1]).containsOnly(Ensemble.LOST);
    }

    @Test
    void aLostNeighbourIsLostAlone() throws Exception {
        BelievedModel model = MeasuredVehicle.model(0.025);
        Variant stuck = new Stuck().in(model.variant(), new double[0]);

        RigidMotion[][] told = neighbours(model, List.of(model.variant(), stuck, model.variant()));

        assertThat(told[0]).doesNotContain(Ensemble.LOST).isEqualTo(told[2]);
        assertThat(told[1]).containsOnly(Ensemble.LOST);
    }

    /** They are asked for in shorter ones then. */
    @Test
    void inLongStepsAllAreLostWithOne() throws Exception {
        BelievedModel model = MeasuredVehicle.model(0.025);
        Variant stuck = new Stuck().in(model.variant(), new double[0]);

        RigidMotion[][] told = neighbours(model, List.of(model.variant(), stuck), Commands.EVENED);

        assertThat(told[0]).containsOnly(Ensemble.LOST);
        assertThat(told[1]).containsOnly(Ensemble.LOST);
    }

    /** An explosion takes the engine very long: long steps are cut less than those of the model. */
    @ParameterizedTest
    @CsvSource({"FROM_ROW_TO_ROW, 600, false", "EVENED, 600, true", "EVENED, 100, false"})
    void longStepsAreCutIntoFewPartsAtMost(Commands commands, double damping, boolean areLost)
            throws Exception {
        BelievedModel model = MeasuredVehicle.model(0.025);
        Vec3 all = new Vec3(1, 1, 1).times(damping * model.variant().body().mass().orElseThrow());
        Variant stiff =
                model.variant()
                        .with(b -> b.effect(new Damping(all, Vec3.ZERO, Vec3.ZERO, Vec3.ZERO)));
        RigidMotion start = new RigidMotion(Vec3.ZERO, Quat.IDENTITY, new Vec3(1, 0, 0), Vec3.ZERO);

        RigidMotion[] told =
                Ensemble.simulate(
                        model.stepping(0.5),
                        MeasuredVehicle.run(model),
                        new int[] {0, 20},
                        List.of(new Ensemble.Entrant(stiff, start)),
                        commands)[0];

        assertThat(told[0].equals(Ensemble.LOST)).isEqualTo(areLost);
    }

    /** Steps that do for the model as it is believed may be too long for what was found. */
    @Test
    void whatGetsLostInLongStepsAloneIsDifferentiatedInShorterOnes() throws Exception {
        BelievedModel model =
                Believed.model(
                        """
                        <scenario><time-step delta="0.01"/>
                          <world-object name="ball" mass="0.145"><sphere radius="0.037"/><gravity/>
                          </world-object>
                        </scenario>
                        """,
                        "ball");
        MeasuredRunBuilder thrown = MeasuredRun.named("thrown");
        for (int k = 0; k < 180; k++) {
            double t = k / 120.0;
            thrown.at(t).position(12 * t + 1e-3 * (k % 3), 0, 6 * t - 4.9 * t * t);
        }
        List<MeasuredRun> runs = List.of(thrown.build());
        Misses of = Misses.of(runs, Noise.of(runs)).getFirst();
        Variant spinning = model.variant().with(b -> b.effect(new MagnusForce(0.12)));
        RigidMotion start =
                new RigidMotion(
                        Vec3.ZERO, Quat.IDENTITY, new Vec3(12, 0, 6), new Vec3(0, 1e-9, 60));
        Stepping far = new Stepping(model, model, model.stepping(0.17), Commands.EVENED);
        Shooting shooting = new Shooting(far, spinning, of);
        Window window = new Window(0, 179, start);

        WindowDerivatives derivatives = shooting.derivatives(window, 1, Moves.NONE);

        assertThat(shooting.rough(window, shooting.motion(window))).containsOnly(Ensemble.LOST);
        assertThat(derivatives.byStart[0][0])
                .isCloseTo(1 / of.deviation(0), within(0.01 / of.deviation(0)));
    }

    @Test
    void aLegThatGetsLostTellsNothing() throws Exception {
        BelievedModel model = MeasuredVehicle.model(0.025);
        List<MeasuredRun> runs = List.of(MeasuredVehicle.run(model));
        Misses of = Misses.of(runs, Noise.of(runs)).getFirst();
        Variant stuck = new Stuck().in(model.variant(), new double[0]);
        Shooting shooting = new Shooting(Stepping.exact(model), stuck, of);
        RigidMotion start = new RigidMotion(Vec3.ZERO, Quat.IDENTITY, new Vec3(1, 0, 0), Vec3.ZERO);
        double[] error = new double[RigidMotion.SIZE];
        Arrays.fill(error, 1);
        double[] rows = new double[of.rows().size()];

        Leg leg = new Leg(0, 5, start, start);
        LegResponse response = new LegResponse(shooting, leg, 1, of.together(0, 1));
        response.carry(error, new double[RigidMotion.SIZE], rows, 0);

        assertThat(error).containsOnly(0);
        assertThat(rows).containsOnly(0);
    }

    /** What steps made of a force that is too stiff may still be finite, and of no use. */
    @Test
    void aMotionIsLostBeforeItsNumbersAreInfinite() throws Exception {
        BelievedModel model = MeasuredVehicle.model(0.025);
        RigidMotion far =
                new RigidMotion(new Vec3(1e150, 0, 0), Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);

        RigidMotion[] told =
                Ensemble.simulate(
                        model,
                        MeasuredVehicle.run(model),
                        new int[] {0, 1},
                        List.of(new Ensemble.Entrant(model.variant(), far)))[0];

        assertThat(told).containsOnly(Ensemble.LOST);
    }

    private static RigidMotion[][] neighbours(BelievedModel model, List<Variant> variants) {
        return neighbours(model, variants, Commands.FROM_ROW_TO_ROW);
    }

    private static RigidMotion[][] neighbours(
            BelievedModel model, List<Variant> variants, Commands commands) {
        RigidMotion start = new RigidMotion(Vec3.ZERO, Quat.IDENTITY, new Vec3(1, 0, 0), Vec3.ZERO);
        return Ensemble.neighbours(
                model,
                MeasuredVehicle.run(model),
                new int[] {0, 10, 20},
                variants.stream().map(v -> new Ensemble.Entrant(v, start)).toList(),
                commands);
    }
}
