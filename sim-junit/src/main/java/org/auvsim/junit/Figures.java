package org.auvsim.junit;

import org.auvsim.core.math.Vec3;

import java.math.BigDecimal;
import java.math.MathContext;

/** Numbers as messages show them: six digits, none that say nothing. */
final class Figures {
    private static final MathContext DIGITS = new MathContext(6);

    private Figures() {}

    static String text(double number) {
        if (!Double.isFinite(number)) {
            return Double.toString(number);
        }
        BigDecimal rounded = new BigDecimal(number).round(DIGITS).stripTrailingZeros();
        return Math.abs(rounded.scale()) > 12 ? rounded.toString() : rounded.toPlainString();
    }

    static String text(Vec3 vector) {
        return "(%s, %s, %s)".formatted(text(vector.x()), text(vector.y()), text(vector.z()));
    }

    /**
     * A tolerance, distance or speed that a test states.
     *
     * @throws IllegalArgumentException if it is negative, infinite or no number
     */
    static void requireLimit(String what, double value, String unit) {
        if (!(value >= 0) || Double.isInfinite(value)) {
            throw new IllegalArgumentException(
                    "%s must be 0 %s or more and finite, but is %s %s"
                            .formatted(what, unit, value, unit));
        }
    }
}
