package org.auvsim.diagnosis.genetic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.genetic.Formula.Sample;
import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.result.ForceResidual;
import org.auvsim.diagnosis.run.EulerAngles;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;

class MissingForcesTest {
    private static final int ROWS = 20;
    private static final int YAW = 9;

    /** Headings of 1 rad and more are measured in every fifth row; the scenario's is 0. */
    private static List<Sample> samples() {
        MeasuredRunBuilder run = MeasuredRun.named("run");
        for (int k = 0; k < ROWS; k++) {
            boolean isMeasured = k % 5 == 0;
            double yaw = isMeasured ? 1 + 0.01 * k : 0;
            run.at(k)
                    .position(k, 0, 0)
                    .orientation(EulerAngles.orientation(0, 0, yaw), true, true, isMeasured);
        }
        List<ForceResidual> forces =
                IntStream.range(0, ROWS)
                        .mapToObj(k -> new ForceResidual(k, new Vec3(1, 0, 0), Vec3.ZERO))
                        .toList();
        return MissingForces.along(
                new DiagnosedRun(run.build(), false, List.of(), List.of(), forces, Set.of()), 0);
    }

    @Test
    void anglesAreThoseThatWereMeasuredNearest() {
        List<Sample> samples = samples();

        assertThat(samples).hasSize(ROWS);
        for (int k = 0; k < ROWS; k++) {
            int nearest = Math.min(15, (k + 2) / 5 * 5);
            assertThat(samples.get(k).variables()[YAW])
                    .isCloseTo(1 + 0.01 * nearest, within(1e-12));
        }
    }
}
