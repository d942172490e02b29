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

    /** 90 of 900 rows have a number, none of them one that every second row would be. */
    @Test
    void ofDotsBetweenGapsNoneIsLost() {
        Curve sparse =
                new Curve(
                        "sparse",
                        Curve.Mark.DOTS,
                        IntStream.range(0, 900)
                                .mapToObj(i -> new Point(i, i % 10 == 5 ? i : Double.NaN))
                                .toList());
        assertThat(sparse.decimated(500).points())
                .hasSize(90)
                .startsWith(new Point(5, 5), new Point(15, 15))
                .endsWith(new Point(895, 895));
    }

    @Test
    void aLineThatLacksSinglePointsGoesOn() {
        List<Point> course =
                IntStream.range(0, 5_000)
                        .mapToObj(i -> new Point(i, i % 3 == 0 ? Double.NaN : i % 7))
                        .toList();
        assertThat(Curve.line("holes", course).decimated(500).points().subList(1, 400))
                .allMatch(point -> Double.isFinite(point.y()));
    }

    @Test
    void aLongGapOfALineStays() {
        List<Point> course =
                IntStream.range(0, 5_000)
                        .mapToObj(i -> new Point(i, i / 1_000 == 2 ? Double.NaN : i % 7))
                        .toList();
        List<Point> kept = Curve.line("gap", course).decimated(500).points();
        List<Double> gaps =
                kept.stream().filter(point -> Double.isNaN(point.y())).map(Point::x).toList();
        assertThat(gaps).hasSizeBetween(40, 60).allMatch(x -> x >= 2_000 && x < 3_000);
        assertThat(kept).filteredOn(point -> Double.isFinite(point.y())).hasSizeBetween(350, 450);
    }

    @Test
    void tooFewPointsAreRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> sawtooth(9).decimated(3))
                .withMessage("a curve keeps its shape with 4 or more points, not 3");
    }
}
