package org.auvsim.diagnosis.reading;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/** Numbers of a file as notices show them: 10.1, 14.93. */
final class Figures {
    private Figures() {}

    /** So many significant digits at most, and no zeros after them. */
    static String shown(double value, int digits) {
        return Double.isFinite(value)
                ? new BigDecimal(value)
                        .round(new MathContext(digits, RoundingMode.HALF_EVEN))
                        .stripTrailingZeros()
                        .toPlainString()
                : String.valueOf(value);
    }

    /** Four significant digits at most. */
    static String shown(double value) {
        return shown(value, 4);
    }
}
