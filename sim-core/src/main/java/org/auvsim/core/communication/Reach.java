package org.auvsim.core.communication;

import org.auvsim.core.math.Vec3;

/** Refuses parameters of transceivers that have no meaning. */
final class Reach {
    private Reach() {}

    static void require(String element, String name, Vec3 position, double range, double loss) {
        if (!position.isFinite()) {
            throw new IllegalArgumentException(
                    "the position of %s '%s' must be finite, but is %s m"
                            .formatted(element, name, position));
        }
        above0("range", element, name, range, "m");
        if (!(loss >= 0 && loss <= 1)) {
            throw new IllegalArgumentException(
                    "the loss of %s '%s' must be 0 to 1, but is %s".formatted(element, name, loss));
        }
    }

    static void above0(String what, String element, String name, double value, String unit) {
        if (!(value > 0) || Double.isInfinite(value)) {
            throw new IllegalArgumentException(
                    "the %s of %s '%s' must be above 0 %s and finite, but is %s"
                            .formatted(what, element, name, unit, value));
        }
    }
}
