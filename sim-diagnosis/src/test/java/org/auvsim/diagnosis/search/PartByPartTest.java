package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.subject.Believed;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;

/**
 * A pole on a pivot, which a jet at its end moves to and fro: upright, where only the jet keeps it
 * from falling, or hanging. The jet is weaker than its model.
 */
class PartByPartTest {
    private static final double GRAVITY = 9.80665;
    private static final double MASS = 2;
    private static final double INERTIA = 0.5;
    private static final double THRUST = 10;
    private static final double GAIN = 0.8;
    private static final double SPACING = 0.05;
    private static final int SAMPLES = 201;
    private static final int SUBSTEPS = 500;
    private static final double NOISE = 0.003;
    private static final double UPRIGHT = 0.1;
    private static final double HANGING = -0.1;

    @Test
    void whatExplainsThePartsOfWhatFallsIsToldWithTheirLength() throws Exception {
        assertThat(notice(UPRIGHT, THRUST, "rotational_drag", "thruster_gain"))
                .contains(
                        "in parts of 2.5 s, each with a start of its own, the runs are explained by"
                            + " thruster_gain (jet): over whole runs errors of the start grow more"
                            + " than a thousandfold; cut them into such parts (--parts 2.5)");
    }

    /** Where a cause explains parts alone, others are missing. */
    @Test
    void whatHangsIsToBeExplainedAsAWhole() throws Exception {
        assertThat(notice(HANGING, THRUST, "thruster_gain")).isEmpty();
    }

    /** Where the model alone explains the parts, no cause is needed for it. */
    @Test
    void aModelThatLacksNothingNeedsNoCause() throws Exception {
        assertThat(notice(UPRIGHT, GAIN * THRUST, "thruster_gain")).isEmpty();
    }

    private static Optional<String> notice(double centre, double thrust, String... ids)
            throws Exception {
        BelievedModel model =
                Believed.model(
                        """
                        <scenario><time-step delta="0.05"/>
                          <world-object name="Pole" mass="2">
                            <box><size x="0.1" y="0.1" z="2"/></box>
                            <inertia xx="0.5" yy="0.5" zz="0.1"/>
                            <centre-of-mass x="0" y="0" z="%s"/>
                            <pinned><axis x="0" y="1" z="0"/></pinned><gravity/>
                            <propulsor name="jet" maximum-thrust="%s">
                              <position x="0" y="0" z="1"/></propulsor>
                          </world-object>
                        </scenario>
                        """
                                .formatted(centre, thrust),
                        "Pole");
        List<MeasuredRun> runs = List.of(run(centre, 1), run(centre, 2));
        Noise noise = Noise.of(runs);
        List<Cause> library = Library.of(model, runs);
        List<Hypothesis> causes =
                Stream.of(ids)
                        .map(id -> named(id, library))
                        .map(c -> Hypothesis.NONE.and(c, new double[c.parameters().size()]))
                        .toList();
        return new PartByPart(
                        Stepping.longer(model).getFirst(),
                        Misses.of(runs, noise),
                        noise,
                        Course.UNHEARD)
                .notice(causes);
    }

    private static Cause named(String id, List<Cause> library) {
        return library.stream().filter(c -> c.id().equals(id)).findFirst().orElseThrow();
    }

    /** I a = m g l sin(angle) + jet, which is told anew in each row by how the pole stands. */
    private static MeasuredRun run(double centre, long seed) {
        Random random = new Random(seed);
        double inertia = INERTIA + MASS * centre * centre;
        MeasuredRunBuilder run = MeasuredRun.named("run" + seed).commands(List.of("jet"));
        double angle = 0.1 * random.nextGaussian();
        double rate = 0;
        for (int k = 0; k < SAMPLES; k++) {
            double wanted = 0.3 * Math.sin(0.8 * k * SPACING + seed);
            double level = Math.clamp(-0.8 * (angle - wanted) - 0.4 * rate, -1, 1);
            double told = angle + NOISE * random.nextGaussian();
            run.at(k * SPACING)
                    .command(0, level)
                    .orientation(Quat.ofAxisAngle(new Vec3(0, 1, 0), told), false, true, false);
            double h = SPACING / SUBSTEPS;
            for (int s = 0; s < SUBSTEPS; s++) {
                double middle = angle + h / 2 * rate;
                double torque = MASS * GRAVITY * centre * Math.sin(middle) + GAIN * THRUST * level;
                rate += h * torque / inertia;
                angle = middle + h / 2 * rate;
            }
        }
        return run.build();
    }
}
