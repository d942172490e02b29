package org.auvsim.experiments.scoreboard;

import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.result.Finding;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

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
        for (int i = 0; i < truth.size(); i++) {
            double off = found.quantities().get(places.get(i)).value() - truth.get(i);
            if (isAngle) {
                off = Math.IEEEremainder(off, 2 * Math.PI);
            }
            squares += off * off;
            size += truth.get(i) * truth.get(i);
            deviation(found, places.get(i)).ifPresent(new Covering(off)::count);
        }
        errors.add(Math.sqrt(squares) / (isAngle ? Math.PI : Math.sqrt(size)));
    }

    private final class Covering {
        private final double off;

        Covering(double off) {
            this.off = off;
        }

        void count(double deviation) {
            stated++;
            if (Math.abs(off) <= NORMAL_95 * deviation) {
                covered++;
            }
        }
    }

    private static Optional<Double> deviation(Finding found, int place) {
        return place < found.deviations().size()
                        && Double.isFinite(found.deviations().get(place))
                        && found.deviations().get(place) > 0
                ? Optional.of(found.deviations().get(place))
                : Optional.empty();
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

    int covered() {
        return covered;
    }

    int stated() {
        return stated;
    }
}
