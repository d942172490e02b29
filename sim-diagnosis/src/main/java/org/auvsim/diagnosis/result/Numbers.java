package org.auvsim.diagnosis.result;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Locale;

/** Numbers as people read them: no digit that says nothing. */
public final class Numbers {
    /** Below this, and from its inverse on, powers of ten are told apart from digits. */
    private static final double SMALL = 1e-3;

    private static final double LARGE = 1e6;

    private Numbers() {}

    /** Two significant digits, and all those before the point: {@code 0.010}, {@code 1234}. */
    public static String rounded(double value) {
        return rounded(value, 2);
    }

    /** So many significant digits, and all those before the point. */
    public static String rounded(double value, int digits) {
        if (!Double.isFinite(value)) {
            return Double.isNaN(value) ? "unknown" : value > 0 ? "infinite" : "minus infinity";
        }
        if (value == 0) {
            return "0";
        }
        int exponent = exponent(value);
        if (isPlain(value)) {
            int kept = Math.max(digits, exponent + 1);
            BigDecimal round = new BigDecimal(value).round(new MathContext(kept));
            return fixed(value, Math.max(0, kept - 1 - exponent(round)));
        }
        return String.format(Locale.ROOT, "%." + (digits - 1) + "e", value)
                .replaceFirst("e([+-])0*(\\d)", "e$1$2")
                .replace("e+", "e");
    }

    /**
     * A value with its standard deviation: {@code 12.4 +- 0.3}. The deviation has one digit, or two
     * if the first is a 1, and the value none beyond it.
     */
    public static String uncertain(double value, double deviation) {
        if (!Double.isFinite(value) || !Double.isFinite(deviation) || deviation <= 0) {
            return rounded(value, 3);
        }
        double largest = Math.max(Math.abs(value), deviation);
        if (!isPlain(largest)) {
            int exponent = exponent(largest);
            double unit = StrictMath.pow(10, exponent);
            return "(%s)e%d".formatted(uncertain(value / unit, deviation / unit), exponent);
        }
        int decimals = 1 - exponent(deviation);
        if (scaled(deviation, decimals).unscaledValue().intValueExact() >= 20) {
            decimals--;
        }
        return "%s +- %s".formatted(fixed(value, decimals), fixed(deviation, decimals));
    }

    private static String fixed(double value, int decimals) {
        BigDecimal fixed = scaled(value, decimals);
        return fixed.signum() == 0
                ? BigDecimal.ZERO.setScale(Math.max(0, decimals)).toPlainString()
                : fixed.toPlainString();
    }

    private static BigDecimal scaled(double value, int decimals) {
        return new BigDecimal(value).setScale(decimals, RoundingMode.HALF_UP);
    }

    /**
     * Share of a whole in percent: {@code 99.1 %}; what rounds to all of it is {@code more than
     * 99.9 %}, as noise decides whether anything is left.
     */
    public static String percent(double share) {
        double percent = 100 * share;
        if (percent > 0 && percent < 0.05) {
            return "less than 0.1 %";
        }
        return percent >= 99.95
                ? "more than 99.9 %"
                : String.format(Locale.ROOT, "%.1f %%", percent);
    }

    /** A probability in percent: {@code 92.5 %}, {@code > 99.9 %}. */
    public static String probability(double value) {
        return value >= 0.9995 ? "> 99.9 %" : value >= 0.0005 ? percent(value) : "< 0.1 %";
    }

    private static boolean isPlain(double value) {
        return Math.abs(value) >= SMALL && Math.abs(value) < LARGE;
    }

    private static int exponent(double value) {
        return exponent(new BigDecimal(value));
    }

    private static int exponent(BigDecimal exact) {
        return exact.precision() - exact.scale() - 1;
    }
}
