package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;

/**
 * A sled whose measured position drifts, and whose start is known. A current, and a blow at the
 * beginning that makes the sled as fast as the current, do the very same.
 */
class DriftingPositionTest {
    private static final double MASS = 10;
    private static final double THRUST = 20;
    private static final double DRAG = 5;
    private static final double DRIFT = 0.01;
    private static final double SPACING = 0.1;
    private static final double NOISE = 0.002;
    private static final int SAMPLES = 300;

    @Test
    void oneCauseIsFoundWhereTwoWouldDoTheSame() throws Exception {
        BelievedModel model = believed();
        List<MeasuredRun> runs = List.of(run(model, 1), run(model, 2));
        List<Cause> causes =
                Library.of(model, runs).stream()
                        .filter(c -> isAmong(c, "current_constant", "impulse", "position_drift"))
                        .toList();
        assertThat(causes).hasSize(3);

        Hypothesis best =
                new Search(model, runs, causes, Way.THOROUGH, new Course(Progress.SILENT))
                        .found()
                        .best()
                        .fit()
                        .hypothesis();

        assertThat(best.causes()).extracting(Cause::id).containsExactly("position_drift");
        assertThat(best.numbers()[0]).isCloseTo(DRIFT, within(1e-4));
    }

    private static boolean isAmong(Cause cause, String... ids) {
        return List.of(ids).contains(cause.id());
    }

    private static BelievedModel believed() throws AuvsmlException {
        return Believed.model(
                """
                <scenario><time-step delta="0.05"/>
                  <world-object name="sled" mass="10"><sphere radius="0.2"/>
                    <isotropic-drag linear="5"/>
                    <propulsor name="motor" maximum-thrust="20"/>
                  </world-object>
                </scenario>
                """,
                "sled");
    }

    /** Speed under constant thrust approaches a steady one, exponentially. */
    private static MeasuredRun run(BelievedModel model, long seed) {
        Random random = new Random(seed);
        MeasuredRunBuilder run = MeasuredRun.named("run" + seed).commands(List.of("motor"));
        double x = 0;
        double v = 0;
        double level = 0;
        for (int k = 0; k < SAMPLES; k++) {
            level = k % 25 == 0 ? random.nextDouble(-1, 1) : level;
            double told = x + DRIFT * k * SPACING + NOISE * random.nextGaussian();
            run.at(k * SPACING).measured(Channel.POSITION, told, Double.NaN, Double.NaN);
            run.command(0, level);
            double steady = THRUST * level / DRAG;
            double kept = Math.exp(-DRAG / MASS * SPACING);
            x += steady * SPACING + (v - steady) * (1 - kept) * MASS / DRAG;
            v = steady + (v - steady) * kept;
        }
        List<Double> deviations = new ArrayList<>(Collections.nCopies(RigidMotion.SIZE, 1e-4));
        return run.start(new KnownStart(model.start(), deviations)).build();
    }
}
