package org.auvsim.auvsml.mapping;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.ToIntFunction;

/** How a name that somebody wrote is shown, and which known names it comes near. */
public final class Names {
    private static final int LONGEST_COMPARED = 64;
    private static final int LONGEST_SHOWN = 80;

    private Names() {}

    /** What somebody wrote, in quotes and not longer than a line. */
    static String quoted(String found) {
        return found.length() <= LONGEST_SHOWN
                ? "'" + found + "'"
                : "'" + found.substring(0, LONGEST_SHOWN) + "...'";
    }

    /** "the nearest known name is 'a'", or a few that are about as near. */
    public static String nearest(String unknown, Collection<String> known) {
        ToIntFunction<String> distance = name -> distance(unknown, name);
        int least = known.stream().mapToInt(distance).min().orElse(0);
        List<String> best =
                known.stream()
                        .filter(name -> distance.applyAsInt(name) <= least + 1)
                        .sorted(Comparator.comparingInt(distance))
                        .limit(3)
                        .map(Names::quoted)
                        .toList();
        return switch (best.size()) {
            case 0 -> "none is known here";
            case 1 -> "the nearest known name is " + best.getFirst();
            default -> "the nearest known names are " + String.join(", ", best);
        };
    }

    /**
     * The same of those alone that the unknown one may well be a slip of: a letter of four, or
     * capitals; empty if there is none.
     */
    public static Optional<String> near(String unknown, Collection<String> known) {
        String small = unknown.toLowerCase(Locale.ROOT);
        List<String> near =
                known.stream()
                        .filter(
                                name ->
                                        distance(small, name.toLowerCase(Locale.ROOT))
                                                <= (small.length() + 1) / 4)
                        .toList();
        return near.isEmpty() ? Optional.empty() : Optional.of(nearest(unknown, near));
    }

    /** 0 if the known one holds what was written, else their edit distance. */
    private static int distance(String unknown, String name) {
        String a = unknown.substring(0, Math.min(unknown.length(), LONGEST_COMPARED));
        return a.length() > 2 && name.contains(a) ? 0 : EditDistance.between(a, name);
    }
}
