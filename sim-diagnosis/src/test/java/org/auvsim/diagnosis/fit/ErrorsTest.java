package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.residual.Outcome;
import org.auvsim.diagnosis.residual.Outcome.Squares;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.run.Reading;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.diagnosis.subject.FreeSphere;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;

/**
 * Errors that are told, of a sphere that stays where it is: its x has outliers, its y never
 * changes, its z goes away.
 */
class ErrorsTest {
    private static final int SAMPLES = 400;
    private static final double NOISE = 0.02;

    private final Set<Reading> astray = new HashSet<>();
    private final MeasuredRun run = run();

    private MeasuredRun run() {
        Random random = new Random(3);
        MeasuredRunBuilder made = MeasuredRun.named("still");
        for (int k = 0; k < SAMPLES; k++) {
            boolean isAstray = k % 50 == 25;
            if (isAstray) {
                astray.add(new Reading(Channel.POSITION, k, 0));
            }
            astray.add(new Reading(Channel.POSITION, k, 1));
            made.at(0.1 * k)
                    .position(
                            (isAstray ? 30 * NOISE : 0) + NOISE * random.nextGaussian(),
                            0.3,
                            0.01 * k + NOISE * random.nextGaussian());
        }
        return made.build();
    }

    private Fit still() throws Exception {
        RigidMotion origin = new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);
        return new Fit(
                Stepping.exact(FreeSphere.believed(0.1)),
                Misses.of(List.of(run), Noise.of(List.of(run))),
                Hypothesis.NONE,
                List.of(List.of(new Window(0, SAMPLES - 1, origin))),
                Knowledge.NONE);
    }

    /** As one would reckon them by hand: what weighs less is off by as much. */
    @Test
    void errorsAreOfAllNumbersButOutliers() throws Exception {
        Squares position = still().errors().getOrDefault(Channel.POSITION, Outcome.NOTHING);

        double sum = 0;
        int count = 0;
        for (int k = 0; k < SAMPLES; k++) {
            for (int axis : new int[] {0, 2}) {
                if (!astray.contains(new Reading(Channel.POSITION, k, axis))) {
                    sum += Math.pow(run.value(Channel.POSITION, k, axis), 2);
                    count++;
                }
            }
        }
        assertThat(position.count()).isEqualTo(count);
        assertThat(position.sum()).isCloseTo(sum, within(1e-9 * sum));
    }

    @Test
    void whatIsLeftOutIsNamed() throws Exception {
        assertThat(still().data().getFirst().uncounted()).isEqualTo(astray);
    }
}
