package org.auvsim.diagnosis.result;

import java.util.List;
import java.util.Set;

/**
 * How a sentence tells the only number of a cause: the words before it and its unit say what it is,
 * where they do; else it is said.
 */
final class OnlyNumber {
    private static final String PURE = "1";

    /** Angles about either axis have one unit, and that of a share by speed or time says little. */
    private static final Set<String> NAMED = Set.of("angle", "tilt", "loss", "fade");

    private OnlyNumber() {}

    /**
     * In words that go on after those for the cause: {@code 0.85 +- 0.01 times what the model has}.
     */
    static String text(Finding of, QuantityGroup number) {
        int dot = number.name().lastIndexOf('.');
        return dot < 0
                ? text(of, number, number.name())
                : text(of, number, number.name().substring(0, dot))
                        + " along "
                        + number.name().substring(dot + 1);
    }

    private static String text(Finding of, QuantityGroup number, String name) {
        if (number.unit().equals(PURE) && name.equals("factor")) {
            return number.text() + " what the model has";
        }
        if (number.unit().equals(PURE) && name.equals("scale")) {
            return number.text() + " times the true one";
        }
        String text = Phrases.tellsSign(of) ? unsigned(number).text() : number.text();
        boolean isNamed = number.unit().equals(PURE) || NAMED.contains(name);
        return isNamed ? name + " " + text : text;
    }

    /** A downward force of 3 N, not of -3 N. */
    private static QuantityGroup unsigned(QuantityGroup of) {
        List<Double> values = of.values().stream().map(Math::abs).toList();
        return new QuantityGroup(of.name(), of.unit(), of.isVector(), values, of.deviations());
    }
}
