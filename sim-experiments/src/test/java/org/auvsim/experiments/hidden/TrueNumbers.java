package org.auvsim.experiments.hidden;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Parameter;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/** The numbers of a hidden effect in the form in which the library searches them. */
final class TrueNumbers {
    /** Told as factors, searched as what is beyond 1. */
    private static final Set<String> FACTORS =
            Set.of("mass_error", "inertia_error", "thruster_gain", "sensor_scale");

    private static final String[] AXES = {".x", ".y", ".z"};

    private TrueNumbers() {}

    /** A number for each parameter; those that the effect does not state are 0, a loss is whole. */
    static double[] of(Cause cause, HiddenEffect hidden) {
        Map<String, Double> numbers = byName(hidden);
        return cause.parameters().stream()
                .map(Parameter::name)
                .mapToDouble(n -> numbers.getOrDefault(n, n.equals("lost") ? 1.0 : 0.0))
                .toArray();
    }

    /** Whether a cause has a parameter for each of them. */
    static boolean haveAPlaceIn(Cause cause, HiddenEffect hidden) {
        return cause.parameters().stream()
                .map(Parameter::name)
                .toList()
                .containsAll(byName(hidden).keySet());
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
