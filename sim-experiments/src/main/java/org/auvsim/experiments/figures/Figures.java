package org.auvsim.experiments.figures;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

/** All figures of the documentation of effects, actuators and fields. */
public final class Figures {
    private Figures() {}

    /** SVG pictures by the names of their files. */
    public static Map<String, String> all() {
        Map<String, String> pictures = new TreeMap<>();
        Stream.of(EffectFigures.all(), ActuatorFigures.all(), FieldFigures.all())
                .flatMap(List::stream)
                .forEach(figure -> pictures.put(figure.name() + ".svg", figure.svg()));
        return pictures;
    }
}
