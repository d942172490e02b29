package org.auvsim.plot.page;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** A named curve of a chart. */
public record Curve(String name, Mark mark, List<Point> points) {
    /** How a curve is drawn. */
    public enum Mark {
        /** A line through its points. */
        LINE,
        /** The same, dashed: what others coincide with, or a fit. */
        DASHED,
        /** The points alone. */
        POINTS,
        /** The same, as small as can be seen: many of them. */
        DOTS
    }

    /** A point of a curve; where one of its numbers is not finite, a gap. */
    public record Point(double x, double y) {
        private boolean isGap() {
            return !Double.isFinite(x) || !Double.isFinite(y);
        }
    }

    /** A curve whose points stay as they are. */
    public Curve {
        points = List.copyOf(points);
    }

    /** A line. */
    public static Curve line(String name, List<Point> points) {
        return new Curve(name, Mark.LINE, points);
    }

    /**
     * The same with {@code most} points at most, those of a single-valued curve in the order of x:
     * of each of equal runs of points the lowest and the highest one stay, in their order, so that
     * no peak is lost; of points without a line between them every second, third ... one stays, so
     * that they look as dense where they are. Gaps take no room from points; a line goes on over
     * those that are shorter than such a run.
     *
     * @throws IllegalArgumentException if fewer than 4 may stay
     */
    public Curve decimated(int most) {
        if (most < 4) {
            throw new IllegalArgumentException(
                    "a curve keeps its shape with 4 or more points, not " + most);
        }
        if (points.size() <= most) {
            return this;
        }
        if (mark == Mark.POINTS || mark == Mark.DOTS) {
            return every(points.stream().filter(point -> !point.isGap()).toList(), most);
        }
        int runs = (most - 2) / 2;
        int inner = points.size() - 2;
        List<Point> kept = new ArrayList<>();
        kept.add(points.getFirst());
        for (int k = 0; k < runs; k++) {
            int from = 1 + (int) ((long) inner * k / runs);
            int to = 1 + (int) ((long) inner * (k + 1) / runs);
            keepExtremes(points.subList(from, to), kept);
        }
        kept.add(points.getLast());
        return new Curve(name, mark, kept);
    }

    private Curve every(List<Point> of, int most) {
        int stride = Math.max(1, Math.ceilDiv(of.size(), most));
        return new Curve(
                name,
                mark,
                IntStream.range(0, Math.ceilDiv(of.size(), stride))
                        .mapToObj(i -> of.get(i * stride))
                        .toList());
    }

    /** Of what is a gap from end to end, one. */
    private static void keepExtremes(List<Point> all, List<Point> kept) {
        List<Point> run = all.stream().filter(point -> !point.isGap()).toList();
        if (run.isEmpty()) {
            kept.add(all.getFirst());
            return;
        }
        int lowest = 0;
        int highest = 0;
        for (int i = 1; i < run.size(); i++) {
            lowest = run.get(i).y() < run.get(lowest).y() ? i : lowest;
            highest = run.get(i).y() > run.get(highest).y() ? i : highest;
        }
        kept.add(run.get(Math.min(lowest, highest)));
        if (lowest != highest) {
            kept.add(run.get(Math.max(lowest, highest)));
        }
    }
}
