package org.auvsim.diagnosis.reading;

import org.auvsim.diagnosis.run.Channel;

import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Units that stand behind a column's name, as in {@code x_mm}, {@code t [s]}, {@code yaw.deg}. */
final class UnitEndings {
    private static final double DEGREE = Math.PI / 180;

    private static final Map<String, Double> TIMES =
            Map.of("s", 1.0, "sec", 1.0, "seconds", 1.0, "ms", 1e-3, "us", 1e-6, "min", 60.0);

    private static final Map<String, Double> LENGTHS =
            Map.of("m", 1.0, "cm", 0.01, "mm", 1e-3, "km", 1000.0);

    private static final Map<String, Double> ANGLES =
            Map.of("rad", 1.0, "deg", DEGREE, "degrees", DEGREE);

    /** What stands for "per" is left out. */
    private static final Map<String, Double> SPEEDS =
            Map.of("ms", 1.0, "mps", 1.0, "cms", 0.01, "mms", 1e-3);

    private static final Map<String, Double> RATES =
            Map.of("rads", 1.0, "radps", 1.0, "degs", DEGREE, "degps", DEGREE, "dps", DEGREE);

    private static final Pattern PER = Pattern.compile("[/_^]");

    /** What is between a name and its unit, and the unit. */
    private static final String BEFORE = "[\\s_.(\\[-]+";

    private static final Pattern ENDING = Pattern.compile(BEFORE + "(.+?)[)\\]]?");

    private UnitEndings() {}

    /**
     * By what a column's numbers are multiplied to be in SI units, if its name is this one,
     * capitals aside, with a unit that such a quantity may have behind it.
     *
     * @param slot of the quantity
     */
    static OptionalDouble factor(String column, String name, int slot) {
        String small = column.toLowerCase(Locale.ROOT);
        if (!small.startsWith(name)) {
            return OptionalDouble.empty();
        }
        Matcher ending = ENDING.matcher(small.substring(name.length()));
        if (!ending.matches()) {
            return OptionalDouble.empty();
        }
        String unit = PER.matcher(ending.group(1)).replaceAll("");
        Map<String, Double> units = units(slot);
        return units.containsKey(unit)
                ? OptionalDouble.of(units.get(unit))
                : OptionalDouble.empty();
    }

    /** The factor of a time, whatever its name is before the unit; 1 without one. */
    static double ofTime(String column) {
        String name = column.toLowerCase(Locale.ROOT).replaceFirst(BEFORE + ".*$", "");
        return factor(column, name, Slots.TIME).orElse(1);
    }

    private static Map<String, Double> units(int slot) {
        if (slot == Slots.TIME) {
            return TIMES;
        }
        for (Channel channel : Channel.values()) {
            if (isOf(slot, Slots.measuredBy(channel)) || isOf(slot, Slots.deviation(channel))) {
                return switch (channel) {
                    case POSITION -> LENGTHS;
                    case ORIENTATION -> ANGLES;
                    case VELOCITY -> SPEEDS;
                    case ANGULAR_VELOCITY -> RATES;
                };
            }
        }
        return Map.of();
    }

    private static boolean isOf(int slot, int first) {
        return first <= slot && slot < first + 3;
    }
}
