package org.auvsim.experiments.scoreboard;

import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.result.Finding;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * How right the numbers of a finding are. A vector counts as one parameter, its error by its
 * length; phases and directions are compared as angles, their errors in parts of pi.
 *
 * <p>What swings is the same with the opposite amplitude half a period later: the nearer of both
 * counts.
 */
final class ParameterCheck {
    private static final double NORMAL_95 = 1.959964;
    private static final List<String> ANGLES = List.of("phase", "direction");

    private final List<Double> errors = new ArrayList<>();
    private final List<Double> expected = new ArrayList<>();
    private int covered;
    private int stated;

    private ParameterCheck() {}

    static ParameterCheck of(Map<String, List<Double>> truth, Finding found) {
        ParameterCheck straight = compared(truth, found);
        if (!truth.containsKey("phase")) {
            return straight;
        }
        ParameterCheck opposite = compared(Opposite.of(truth), found);
        return opposite.sum() < straight.sum() ? opposite : straight;
    }

    private static ParameterCheck compared(Map<String, List<Double>> truth, Finding found) {
        ParameterCheck check = new ParameterCheck();
        truth.forEach((name, values) -> check.compare(name, values, found));
        return check;
    }

    private double sum() {
        return errors.stream().mapToDouble(Double::doubleValue).sum();
    }

    private void compare(String name, List<Double> truth, Finding found) {
        List<Integer> places = places(name, found.quantities());
        if (places.size() != truth.size()) {
            return; // told otherwise: it cannot be compared
        }
        boolean isAngle = ANGLES.contains(name);
        double squares = 0;
        double size = 0;
        double variances = 0;
        double squaresOfVariances = 0;
        for (int i = 0; i < truth.size(); i++) {
            double off = found.quantities().get(places.get(i)).value() - truth.get(i);
            if (isAngle) {
                off = Math.IEEEremainder(off, 2 * Math.PI);
            }
            squares += off * off;
            size += truth.get(i) * truth.get(i);
            double deviation = deviation(found, places.get(i));
            variances += deviation * deviation;
            squaresOfVariances += Math.pow(deviation, 4);
            if (!Double.isNaN(deviation)) {
                count(Math.abs(off) <= NORMAL_95 * deviation);
            }
        }
        double whole = isAngle ? Math.PI : Math.sqrt(size);
        errors.add(Math.sqrt(squares) / whole);
        if (!Double.isNaN(variances)) {
            expected.add(medianLength(variances, squaresOfVariances) / whole);
        }
    }

    /**
     * Half of all normal vectors of such variances are shorter: their squares are as of so many
     * equal ones (Satterthwaite 1946), whose median is near (Wilson &amp; Hilferty 1931).
     */
    private static double medianLength(double variances, double squaresOfVariances) {
        double alike = variances * variances / squaresOfVariances;
        return Math.sqrt(variances * Math.pow(1 - 2 / (9 * alike), 3));
    }

    private void count(boolean isCovered) {
        stated++;
        if (isCovered) {
            covered++;
        }
    }

    /** NaN if there is none. */
    private static double deviation(Finding found, int place) {
        return place < found.deviations().size()
                        && Double.isFinite(found.deviations().get(place))
                        && found.deviations().get(place) > 0
                ? found.deviations().get(place)
                : Double.NaN;
    }

    private static List<Integer> places(String name, List<Quantity> quantities) {
        List<Integer> places = new ArrayList<>();
        for (int i = 0; i < quantities.size(); i++) {
            String of = quantities.get(i).name();
            if (of.equals(name) || of.startsWith(name + ".")) {
                places.add(i);
            }
        }
        return places;
    }

    List<Double> errors() {
        return errors;
    }

    /** What the stated deviations say of each: half of all errors are smaller than that. */
    List<Double> expected() {
        return expected;
    }

    int covered() {
        return covered;
    }

    int stated() {
        return stated;
    }
}
