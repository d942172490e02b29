package org.auvsim.cli.feed;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.stream.IntStream;

class ComparisonTest {
    private static MeasuredLog.Row at(double time, double x) {
        return new MeasuredLog.Row(time, new Vec3(x, 0, 0));
    }

    @Test
    void takesTheSimulatedWayAsStraightBetweenSteps() {
        Comparison comparison = new Comparison(List.of(at(0.25, 3), at(1, 8), at(1.5, 0)));

        comparison.stepped(at(0, 0), at(0, 0));
        comparison.stepped(at(1, 8), at(1, 8)); // at 0.25 s it was at 2 m
        comparison.stepped(at(2, 8), at(2, 8));

        assertThat(comparison.compared()).isEqualTo(3);
        assertThat(comparison.largest()).isCloseTo(8, within(1e-12));
        assertThat(comparison.rms()).isCloseTo(Math.sqrt((1 + 0 + 64) / 3.0), within(1e-12));
    }

    @Test
    void aCorrectionAfterTheStepIsNotOnTheWayThere() {
        Comparison comparison = new Comparison(List.of(at(0.5, 0), at(1, 4), at(1.5, 4)));

        comparison.stepped(at(0, 0), at(0, 0));
        comparison.stepped(at(1, 2), at(1, 4)); // at 0.5 s it was at 1 m
        comparison.stepped(at(2, 6), at(2, 9)); // at 1.5 s it was at 5 m

        assertThat(comparison.rms()).isCloseTo(Math.sqrt(2 / 3.0), within(1e-12));
    }

    @Test
    void leavesOutWhatCameBeforeTheFirstStep() {
        Comparison comparison = new Comparison(List.of(at(0, 5), at(1, 5)));
        comparison.stepped(at(1, 4), at(1, 4));
        assertThat(comparison.compared()).isEqualTo(1);
        assertThat(comparison.rms()).isEqualTo(1);
    }

    @Test
    void logsInterpolateBetweenRowsAndSplitIntoNthAndOthers() {
        MeasuredLog log =
                new MeasuredLog(IntStream.range(0, 5).mapToObj(i -> at(i, i * i)).toList());

        assertThat(log.positionAt(2)).isEqualTo(new Vec3(4, 0, 0));
        assertThat(log.positionAt(2.5)).isEqualTo(new Vec3(6.5, 0, 0));
        assertThat(log.positionAt(4 + 1e-9)).isEqualTo(new Vec3(16, 0, 0));
        assertThat(log.rowsUntil(2 - 1e-9)).isEqualTo(3);
        assertThat(log.rowsUntil(1.5)).isEqualTo(2);
        assertThat(log.everyNth(2)).containsExactly(at(1, 1), at(3, 9));
        assertThat(log.allButEveryNth(2)).containsExactly(at(0, 0), at(2, 4), at(4, 16));
        assertThat(log.everyNth(0)).isEmpty();
        assertThat(log.allButEveryNth(0)).hasSize(5);
        assertThat(log.allButEveryNth(1)).isEmpty();
    }
}
