package org.auvsim.diagnosis.search;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.result.Numbers;

/**
 * A number of a cause, under a name for people, and what it is where the cause leaves the model as
 * it is.
 *
 * @param neutral 1 of a factor, what the model has of a restitution
 */
record Amount(Quantity of, double neutral) {
    private static final String PURE = "1";
    private static final int DIGITS = 3;

    /** Of three digits one at least differs from those of a number that is further away. */
    private static final double NEAR = 0.01;

    /** The so many-th number of a cause. */
    static Amount of(Cause cause, double[] theta, int number) {
        Quantity told = cause.quantities(theta).get(number);
        double neutral = cause.quantities(new double[theta.length]).get(number).value();
        return new Amount(new Quantity(name(cause, told), told.unit(), told.value()), neutral);
    }

    /** {@code thruster gain (port) factor}; a delay of {@code sensor_delay} is named once. */
    private static String name(Cause cause, Quantity told) {
        String id = cause.id().replace('_', ' ');
        String named = id + cause.subject().map(" (%s)"::formatted).orElse("");
        return id.endsWith(" " + told.name()) ? named : named + " " + told.name();
    }

    /** Beyond that which changes nothing. */
    double excess() {
        return of.value() - neutral;
    }

    /** Whether something is multiplied by it. */
    boolean isFactor() {
        return neutral == 1 && of.unit().equals(PURE);
    }

    /** Whether it and another one can be added: both of the same unit, and 0 for nothing. */
    boolean isAddedTo(Amount other) {
        return neutral == 0 && other.neutral == 0 && of.unit().equals(other.of.unit());
    }

    /** Rounded, but so that it shows by how much it differs from what changes nothing. */
    String number() {
        double apart = Math.abs(excess() / of.value());
        boolean isNear = neutral != 0 && apart > 0 && apart < NEAR;
        int digits = isNear ? DIGITS - (int) Math.floor(StrictMath.log10(apart / NEAR)) : DIGITS;
        return Numbers.rounded(of.value(), digits);
    }

    /** In words: {@code a clock offset of 0.700 s}. */
    String words() {
        String unit = of.unit().equals(PURE) ? "" : " " + of.unit();
        String otherwise =
                neutral == 0 || isFactor()
                        ? ""
                        : " instead of " + Numbers.rounded(neutral, DIGITS) + unit;
        return "%s %s of %s%s%s"
                .formatted(
                        "aeio".indexOf(of.name().charAt(0)) < 0 ? "a" : "an",
                        of.name(),
                        number(),
                        unit,
                        otherwise);
    }
}
