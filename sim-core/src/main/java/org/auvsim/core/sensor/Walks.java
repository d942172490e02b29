package org.auvsim.core.sensor;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;

/**
 * Values of the walks of one sensor that were found lately, so that the next samples need not find
 * them again. They are functions of their sample numbers: remembering changes no result.
 */
final class Walks {
    private static final int LEVELS = Long.SIZE;

    /** The walk of one stream: at powers of two, and at the last middle of each level. */
    static final class Walk {
        private final double[] atPower = new double[LEVELS];
        private final long[] middle = new long[LEVELS];
        private final double[] atMiddle = new double[LEVELS];

        private Walk() {
            Arrays.fill(atPower, Double.NaN);
        }

        /** The value at 2^level; NaN if unknown. */
        double atPower(int level) {
            return atPower[level];
        }

        double keepAtPower(int level, double value) {
            atPower[level] = value;
            return value;
        }

        /** Whether the value at this middle of a level's interval is known. */
        boolean knows(int level, long at) {
            return middle[level] == at;
        }

        double atMiddle(int level) {
            return atMiddle[level];
        }

        double keepAtMiddle(int level, long at, double value) {
            middle[level] = at;
            atMiddle[level] = value;
            return value;
        }
    }

    private final Map<Integer, Walk> byStream = new HashMap<>();

    Walk of(int stream) {
        return byStream.computeIfAbsent(stream, _ -> new Walk());
    }
}
