package org.auvsim.diagnosis.cause;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.junit.jupiter.api.Test;

import java.util.List;

/** What is known of where and when a body went, from numbers that need not be in each row. */
class PathTest {
    /** At 1 m/s eastwards, a fix in every so many rows, a depth in each. */
    private static MeasuredRun run(double begin, int fixedEach) {
        MeasuredRunBuilder run = MeasuredRun.named("run");
        for (int k = 0; k < 1000; k++) {
            double x = k % fixedEach == fixedEach / 2 ? 0.1 * k : Double.NaN;
            run.at(begin + 0.1 * k).position(x, Double.isNaN(x) ? x : 0, -5);
        }
        return run.build();
    }

    private static Path path(MeasuredRun... runs) {
        return Path.of(List.of(runs), Tank.bare().variant().body());
    }

    @Test
    void aFixInSomeRowsTellsTheSpeedAndThePlaces() {
        Path path = path(run(0, 10));

        assertThat(path.speed()).isCloseTo(1, within(0.02));
        assertThat(path.range()).isCloseTo(99, within(2.0));
        assertThat(path.places()).hasSizeGreaterThan(90);
    }

    /** An hour between two runs is none in which anything could begin. */
    @Test
    void timesAreThoseOfRuns() {
        double[] times = path(run(0, 1), run(3600, 1), run(3650, 1)).times(10);

        assertThat(times).hasSize(10).isSorted();
        for (double time : times) {
            assertThat(time < 100 || (time > 3600 && time < 3750)).as("%s s", time).isTrue();
        }
        assertThat(times[3]).isLessThan(100);
        assertThat(times[4]).isGreaterThan(3600);
    }
}
