package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Numbers;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * Positions that were found to be told on a scale of feet along some axes: sensors are off by per
 * cents.
 */
final class Feet {
    private static final String SCALE = "sensor_scale";
    private static final double A_FOOT = 0.3048;

    private static final int DIGITS = 4;

    /** The same factor, as it may be found (relative). */
    private static final double NEAR = 0.01;

    private Feet() {}

    /** What is to be said of it; empty if no scale is like that. */
    static Optional<String> notice(List<Finding> found) {
        return found.stream()
                .filter(of -> of.cause().equals(SCALE))
                .findFirst()
                .flatMap(Feet::ofScale);
    }

    private static Optional<String> ofScale(Finding scale) {
        List<Integer> axes =
                IntStream.range(0, scale.quantities().size())
                        .filter(i -> isOfFeet(scale.quantities().get(i).value()))
                        .boxed()
                        .toList();
        return axes.isEmpty()
                ? Optional.empty()
                : Optional.of(
                        "%s %s found to be told %s times as large as it is, and a metre is %s feet: is that in feet? If so, map it with a scale of %s (--mapping)"
                                .formatted(
                                        axes.stream()
                                                .map(i -> String.valueOf("xyz".charAt(i)))
                                                .collect(Collectors.joining(", ")),
                                        axes.size() == 1 ? "was" : "were each",
                                        Numbers.rounded(
                                                scale.quantities().get(axes.getFirst()).value(),
                                                DIGITS),
                                        Numbers.rounded(1 / A_FOOT, DIGITS),
                                        A_FOOT));
    }

    private static boolean isOfFeet(double factor) {
        return Math.abs(factor * A_FOOT - 1) < NEAR;
    }
}
