package org.auvsim.plot.page;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.auvsim.plot.page.Curve.Point;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.stream.IntStream;

class CurveTest {
    private static Curve sawtooth(int points) {
        List<Point> course = IntStream.range(0, points).mapToObj(i -> new Point(i, i % 7)).toList();
        return Curve.line("saw", course);
    }

    @Test
    void aShortCurveStaysAsItIs() {
        assertThat(sawtooth(100).decimated(100)).isEqualTo(sawtooth(100));
    }

    @Test
    void aLongCurveKeepsItsEndsAndOrderAndSize() {
        List<Point> kept = sawtooth(10_001).decimated(200).points();
        assertThat(kept).hasSizeBetween(150, 200);
        assertThat(kept.getFirst()).isEqualTo(new Point(0, 0));
        assertThat(kept.getLast()).isEqualTo(new Point(10_000, 10_000 % 7));
        assertThat(kept.stream().map(Point::x)).isSorted();
    }

    @Test
    void aPeakOfOnePointStays() {
        List<Point> flat =
                IntStream.range(0, 5_000)
                        .mapToObj(i -> new Point(i, i == 3_217 ? 9 : i == 1_111 ? -4 : 0))
                        .toList();
        assertThat(Curve.line("peak", flat).decimated(50).points())
                .contains(new Point(3_217, 9), new Point(1_111, -4));
    }

    @Test
    void ofDotsEveryNthStays() {
        Curve dots = new Curve("dots", Curve.Mark.DOTS, sawtooth(1_001).points());
        assertThat(dots.decimated(500).points())
                .hasSize(334)
                .startsWith(new Point(0, 0), new Point(3, 3), new Point(6, 6), new Point(9, 2))
                .endsWith(new Point(999, 999 % 7));
    }

    @Test
    void tooFewPointsAreRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> sawtooth(9).decimated(3))
                .withMessage("a curve keeps its shape with 4 or more points, not 3");
    }
}
