package org.auvsim.experiments.scoreboard;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** The same swing told the other way round. */
final class Opposite {
    private Opposite() {}

    /** Half a period later with the opposite vector, or direction. */
    static Map<String, List<Double>> of(Map<String, List<Double>> parameters) {
        Map<String, List<Double>> opposite = new TreeMap<>();
        parameters.forEach(
                (name, values) ->
                        opposite.put(
                                name,
                                values.stream()
                                        .map(
                                                v ->
                                                        switch (name) {
                                                            case "phase", "direction" ->
                                                                    v + Math.PI;
                                                            case "u", "force" -> -v;
                                                            default -> v;
                                                        })
                                        .toList()));
        return opposite;
    }
}
