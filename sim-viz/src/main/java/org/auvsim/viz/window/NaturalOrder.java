package org.auvsim.viz.window;

import java.math.BigInteger;
import java.util.Comparator;
import java.util.regex.Pattern;

/**
 * The order in which people count names: Ball 9 stands before Ball 10, and capitals are no matter.
 */
final class NaturalOrder implements Comparator<String> {
    static final Comparator<String> OF_TEXTS = new NaturalOrder();

    private static final Pattern SEAMS = Pattern.compile("(?<=\\d)(?=\\D)|(?<=\\D)(?=\\d)");

    private NaturalOrder() {}

    @Override
    public int compare(String one, String other) {
        String[] these = SEAMS.split(one, -1);
        String[] those = SEAMS.split(other, -1);
        for (int i = 0; i < Math.min(these.length, those.length); i++) {
            int difference = compareParts(these[i], those[i]);
            if (difference != 0) {
                return difference;
            }
        }
        return Integer.compare(these.length, those.length);
    }

    private static int compareParts(String one, String other) {
        return isNumber(one) && isNumber(other)
                ? new BigInteger(one).compareTo(new BigInteger(other))
                : one.compareToIgnoreCase(other);
    }

    private static boolean isNumber(String part) {
        return !part.isEmpty() && part.charAt(0) >= '0' && part.charAt(0) <= '9';
    }
}
