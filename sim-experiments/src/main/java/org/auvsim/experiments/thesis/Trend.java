package org.auvsim.experiments.thesis;

import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;

/** A figure of the thesis: something that grows with the number of bodies, and its fit. */
public enum Trend {
    /** Figure 8.4. */
    RESTRICTER("Figure 8.4", "restricter", "operations", 1, 0.999991),
    /** Figure 8.5. */
    OCTREE("Figure 8.5", "octree", "operations", 1, 0.999567),
    /** Figure 8.6. */
    FINDER("Figure 8.6", "collision finder", "operations", 2, 0.991847),
    /** Figure 8.7, whose R^2 the thesis does not give. */
    WALL_TIME("Figure 8.7", "wall time", "s", 2, Double.NaN),
    /** Figure 8.7, the other fit. */
    WALL_TIME_CUBIC("Figure 8.7", "wall time", "s", 3, Double.NaN);

    private static final List<String> ORDERS = List.of("linear", "quadratic", "cubic");

    private final String figure;
    private final String what;
    private final String unit;
    private final int degree;
    private final double thesisRSquared;

    Trend(String figure, String what, String unit, int degree, double thesisRSquared) {
        this.figure = figure;
        this.what = what;
        this.unit = unit;
        this.degree = degree;
        this.thesisRSquared = thesisRSquared;
    }

    /** What grows, and by which fit. */
    public String title() {
        return figure + ": " + what + ", " + order() + " fit";
    }

    private String order() {
        return ORDERS.get(degree - 1);
    }

    /** Its unit. */
    public String unit() {
        return unit;
    }

    /** R^2 of the thesis' own fit, where it gives one. */
    public OptionalDouble thesisRSquared() {
        return Double.isNaN(thesisRSquared)
                ? OptionalDouble.empty()
                : OptionalDouble.of(thesisRSquared);
    }

    /** Its values, one for each number of bodies. */
    public double[] values(List<StageCost> costs) {
        return costs.stream().mapToDouble(this::value).toArray();
    }

    private double value(StageCost cost) {
        return switch (this) {
            case RESTRICTER -> cost.restricter();
            case OCTREE -> cost.partitioner();
            case FINDER -> cost.finder();
            case WALL_TIME, WALL_TIME_CUBIC -> cost.wallSeconds();
        };
    }

    /** Whether there are enough numbers of bodies for its fit. */
    public boolean isFittable(List<StageCost> costs) {
        return costs.size() >= degree + 2;
    }

    /** Its fit. */
    public PolynomialFit fit(List<StageCost> costs) {
        double[] bodies = costs.stream().mapToDouble(StageCost::bodies).toArray();
        return PolynomialFit.of(bodies, values(costs), degree);
    }

    /** Its fit as a line of text. */
    public String describe(List<StageCost> costs) {
        PolynomialFit fit = fit(costs);
        String thesis =
                thesisRSquared().isPresent()
                        ? "; in the thesis " + thesisRSquared().getAsDouble()
                        : "";
        return String.format(
                Locale.ROOT,
                "%-45s R^2 = %.6f%s; leading coefficient %.4g",
                title(),
                fit.rSquared(),
                thesis,
                fit.leading());
    }
}
