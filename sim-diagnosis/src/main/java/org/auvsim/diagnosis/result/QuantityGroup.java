package org.auvsim.diagnosis.result;

import org.auvsim.diagnosis.cause.Quantity;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * A number of a cause, or a vector of numbers whose names end with {@code .x}, {@code .y} and so
 * on, the first with {@code .x}. What is told along another axis alone keeps its name.
 *
 * @param name of the number or of the vector
 * @param unit 1 for pure numbers
 * @param values NaN of what is not determined, where no deviations tell of that
 * @param deviations standard deviations of the values, NaN of what leaves no trace; empty if none
 *     can be stated
 */
public record QuantityGroup(
        String name, String unit, boolean isVector, List<Double> values, List<Double> deviations) {
    private static final String AXES = "xyz";

    /** A number so many standard deviations from 0 is surely something else. */
    private static final double SURE = 3;

    /** What is this share of a vector's largest number is what rounding leaves of 0. */
    private static final double NOTHING = 1e-12;

    /** Deviations of so many times a vector's largest number say nothing of a component. */
    private static final double FAR = 10;

    /** The lists cannot be changed. */
    public QuantityGroup {
        values = List.copyOf(values);
        deviations = List.copyOf(deviations);
    }

    /**
     * The groups of a cause's numbers, in their order.
     *
     * @param deviations of each, or empty
     */
    public static List<QuantityGroup> of(List<Quantity> quantities, List<Double> deviations) {
        List<QuantityGroup> groups = new ArrayList<>();
        int from = 0;
        while (from < quantities.size()) {
            String name = vectorName(quantities.get(from));
            int to = from + 1;
            while (to < quantities.size() && isNext(quantities.get(to), name, to - from)) {
                to++;
            }
            groups.add(group(quantities.subList(from, to), part(deviations, from, to)));
            from = to;
        }
        return groups;
    }

    /** Those of a finding. */
    public static List<QuantityGroup> of(Finding finding) {
        return of(finding.quantities(), finding.deviations());
    }

    private static List<Double> part(List<Double> all, int from, int to) {
        return all.isEmpty() ? all : all.subList(from, to);
    }

    /** Whether a number is that along the next axis of a vector. */
    private static boolean isNext(Quantity quantity, String vector, int axis) {
        return !vector.isEmpty()
                && axis < AXES.length()
                && quantity.name().equals(vector + "." + AXES.charAt(axis));
    }

    private static QuantityGroup group(List<Quantity> of, List<Double> deviations) {
        Quantity first = of.getFirst();
        boolean isVector = of.size() > 1;
        return new QuantityGroup(
                isVector ? vectorName(first) : first.name(),
                first.unit(),
                isVector,
                of.stream().map(Quantity::value).toList(),
                deviations);
    }

    /** The vector that a number begins; empty if it begins none. */
    private static String vectorName(Quantity quantity) {
        String name = quantity.name();
        return name.endsWith(".x") ? name.substring(0, name.length() - 2) : "";
    }

    /** The values with their deviations and their unit: {@code 12.4 +- 0.3 kg/m}. */
    public String text() {
        String numbers =
                IntStream.range(0, values.size())
                        .mapToObj(this::text)
                        .collect(Collectors.joining(", "));
        return (isVector ? "(" + numbers + ")" : numbers) + (isAnyDetermined() ? unitText() : "");
    }

    /** The deviations, NaN of values that are not determined; empty if none can be stated. */
    public List<Double> toldDeviations() {
        return IntStream.range(0, deviations.size())
                .mapToObj(i -> isDetermined(i) ? deviations.get(i) : Double.NaN)
                .toList();
    }

    private String text(int i) {
        if (!isDetermined(i)) {
            return "not determined";
        }
        double largest = values.stream().mapToDouble(Math::abs).max().orElseThrow();
        double value = Math.abs(values.get(i)) <= NOTHING * largest ? 0 : values.get(i);
        return Numbers.uncertain(value, deviations.isEmpty() ? Double.NaN : deviations.get(i));
    }

    private boolean isAnyDetermined() {
        return IntStream.range(0, values.size()).anyMatch(this::isDetermined);
    }

    private boolean isDetermined(int i) {
        if (deviations.isEmpty()) {
            return !Double.isNaN(values.get(i));
        }
        double deviation = deviations.get(i);
        boolean isAnyAngle = unit.equals("rad") && deviation > Math.PI;
        return Double.isFinite(deviation) && deviation <= FAR * largest() && !isAnyAngle;
    }

    /** The largest number that is surely not 0; infinite if there is none. */
    private double largest() {
        return IntStream.range(0, values.size())
                .filter(i -> Math.abs(values.get(i)) > SURE * deviations.get(i))
                .mapToDouble(i -> Math.abs(values.get(i)))
                .max()
                .orElse(Double.POSITIVE_INFINITY);
    }

    private String unitText() {
        if (unit.equals("1")) {
            return name.equals("factor") ? " times" : "";
        }
        return " " + unit;
    }
}
