package org.auvsim.experiments.figures;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** All figures of the documentation that are drawn by the simulator. */
public final class Figures {
    private Figures() {}

    /** Of effects, actuators and fields: SVG pictures by the names of their files. */
    public static Map<String, String> ofEffects() {
        return pictures(List.of(EffectFigures.all(), ActuatorFigures.all(), FieldFigures.all()));
    }

    /** Of causes of discrepancies, likewise. */
    public static Map<String, String> ofCauses() {
        return pictures(List.of(CauseFigures.all(), List.of(ShakingFigure.drawn())));
    }

    private static Map<String, String> pictures(List<List<Figure>> figures) {
        Map<String, String> pictures = new TreeMap<>();
        figures.stream()
                .flatMap(List::stream)
                .forEach(figure -> pictures.put(figure.name() + ".svg", figure.svg()));
        return pictures;
    }
}
