package org.auvsim.experiments.hidden;

import org.auvsim.diagnosis.cause.Cause;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/** The numbers of a hidden effect in the form in which the library searches them. */
final class TrueNumbers {
    /** Told as factors, searched as what is beyond 1. */
    private static final Set<String> FACTORS =
            Set.of("mass_error", "inertia_error", "thruster_gain", "sensor_scale");

    /** Searched for by what they do along the path. */
    private static final Set<String> PLACED = Set.of("magnetic", "tether_spring", "current_vortex");

    private static final String[] AXES = {".x", ".y", ".z"};

    private TrueNumbers() {}

    /** A number for each parameter; those that the effect does not state are 0, a loss is whole. */
    static double[] of(Cause cause, HiddenEffect hidden) {
        Map<String, Double> numbers = byName(hidden);
        double[] theta = new double[cause.parameters().size()];
        for (int i = 0; i < theta.length; i++) {
            String name = cause.parameters().get(i).name();
            theta[i] = numbers.getOrDefault(name, name.equals("lost") ? 1.0 : 0.0);
        }
        for (int i = 0; tellsOtherwise(cause) && i < theta.length; i++) {
            if (!numbers.containsKey(cause.parameters().get(i).name())) {
                theta[i] = solved(cause, theta, i, numbers);
            }
        }
        return theta;
    }

    /** What is told in place of a parameter grows with it evenly, all others as they are. */
    private static double solved(Cause cause, double[] theta, int i, Map<String, Double> numbers) {
        double[] one = theta.clone();
        one[i] = 1;
        double atZero = cause.quantities(theta).get(i).value();
        double atOne = cause.quantities(one).get(i).value();
        double wanted = numbers.getOrDefault(cause.quantities(theta).get(i).name(), 0.0);
        return (wanted - atZero) / (atOne - atZero);
    }

    /** Whether it tells something else in place of a parameter. */
    private static boolean tellsOtherwise(Cause cause) {
        return PLACED.contains(cause.id());
    }

    /** Whether a cause has a parameter for each of them. */
    static boolean haveAPlaceIn(Cause cause, HiddenEffect hidden) {
        List<String> places = new ArrayList<>();
        cause.parameters().forEach(parameter -> places.add(parameter.name()));
        if (tellsOtherwise(cause)) {
            double[] any = new double[cause.parameters().size()];
            cause.quantities(any).forEach(quantity -> places.add(quantity.name()));
        }
        return places.containsAll(byName(hidden).keySet());
    }

    private static Map<String, Double> byName(HiddenEffect hidden) {
        Map<String, Double> numbers = new TreeMap<>();
        List<Double> phase = hidden.parameters().getOrDefault("phase", List.of());
        hidden.parameters()
                .forEach(
                        (name, values) -> {
                            boolean swings =
                                    !phase.isEmpty()
                                            && (values.size() == AXES.length
                                                    || name.equals("amplitude"));
                            for (int i = 0; i < values.size() && !name.equals("phase"); i++) {
                                String axis = values.size() == 1 ? "" : AXES[i];
                                double v = values.get(i);
                                if (swings) {
                                    numbers.put("sine" + axis, v * Math.cos(phase.getFirst()));
                                    numbers.put("cosine" + axis, v * Math.sin(phase.getFirst()));
                                } else {
                                    boolean isFactor = FACTORS.contains(hidden.cause());
                                    numbers.put(name + axis, isFactor ? v - 1 : v);
                                }
                            }
                        });
        return numbers;
    }
}
