package org.auvsim.experiments.figures;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;

/** A named line of a figure. */
record Series(String name, List<Point> points) {
    /** A point of a line. */
    record Point(double x, double y) {}

    /** A function over a range. */
    static Series of(String name, double from, double to, DoubleUnaryOperator function) {
        List<Point> points = new ArrayList<>();
        int steps = 200;
        for (int k = 0; k <= steps; k++) {
            double x = from + (to - from) * k / steps;
            points.add(new Point(x, function.applyAsDouble(x)));
        }
        return new Series(name, points);
    }
}
