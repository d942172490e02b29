package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Quantity;

import java.util.Locale;

/**
 * A number of a cause, and what it is where the cause leaves the model as it is.
 *
 * @param neutral 1 of a factor, what the model has of a restitution
 */
record Amount(Quantity of, double neutral) {
    private static final String PURE = "1";

    /** The so many-th number of a cause, under its name. */
    static Amount of(Cause cause, double[] theta, int number) {
        Quantity told = cause.quantities(theta).get(number);
        double neutral = cause.quantities(new double[theta.length]).get(number).value();
        return new Amount(
                new Quantity(cause.name() + " " + told.name(), told.unit(), told.value()), neutral);
    }

    /** Beyond that which changes nothing. */
    double excess() {
        return of.value() - neutral;
    }

    /** Whether something is multiplied by it. */
    boolean isFactor() {
        return neutral == 1 && of.unit().equals(PURE);
    }

    /** Its excess in words. */
    String term() {
        return neutral == 0 ? of.name() : "(%s - %s)".formatted(of.name(), text(neutral));
    }

    /** A space and the unit; nothing after pure numbers. */
    String unitText() {
        return of.unit().equals(PURE) ? "" : " " + of.unit();
    }

    private static String text(double value) {
        return value == Math.rint(value)
                ? String.valueOf((long) value)
                : String.format(Locale.ROOT, "%.3g", value);
    }
}
