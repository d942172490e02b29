package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Numbers;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * A cause that the runs ask for, but whose strength they do not tell: twice as strong, and further
 * away or slower, it would do the same along these paths, and so would others.
 */
final class LooseStrength {
    /** Of numbers that say where, when and about what something acts, not how strongly. */
    private static final Set<String> NO_STRENGTH = Set.of("1", "m", "s", "rad", "rad/s", "rad/m");

    private LooseStrength() {}

    /** What is to be said of each such cause. */
    static List<String> notices(List<Finding> found) {
        return found.stream().flatMap(of -> notice(of).stream()).toList();
    }

    private static Optional<String> notice(Finding of) {
        return largest(of).stream()
                .filter(number -> number.deviation > Math.abs(number.quantity.value()))
                .findFirst()
                .map(number -> words(of, number));
    }

    /** A number, and its standard deviation. */
    private record Stated(Quantity quantity, double deviation) {
        /** Of all numbers of a vector, {@code u.x} among them, what stands before the point. */
        String vector() {
            return quantity.name().split("\\.", -1)[0];
        }

        boolean isLargerThan(Stated other) {
            return Math.abs(quantity.value()) > Math.abs(other.quantity.value());
        }
    }

    /** Of each vector the largest number. */
    private static List<Stated> largest(Finding of) {
        Map<String, Stated> largest = new LinkedHashMap<>();
        for (int i = 0; i < of.deviations().size(); i++) {
            Stated number = new Stated(of.quantities().get(i), of.deviations().get(i));
            if (!NO_STRENGTH.contains(number.quantity.unit())) {
                largest.merge(number.vector(), number, (a, b) -> b.isLargerThan(a) ? b : a);
            }
        }
        return new ArrayList<>(largest.values());
    }

    private static String words(Finding of, Stated number) {
        return "how strong %s is these runs do not tell (%s %s +- %s %s): stronger, and further away or slower, it would do the same along their paths, and so may something else; longer runs, or other paths, tell"
                .formatted(
                        of.name(),
                        number.quantity.name(),
                        Numbers.rounded(number.quantity.value()),
                        Numbers.rounded(number.deviation),
                        number.quantity.unit());
    }
}
