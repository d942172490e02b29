package org.auvsim.auvsml.mapping;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.ToIntFunction;
import java.util.stream.Collectors;

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
     * The known names that an unknown one may well be a slip of, those that are nearest: a letter
     * of four is another, two have changed places, or capitals differ; empty if there is none.
     */
    public static List<String> near(String unknown, Collection<String> known) {
        String small = unknown.toLowerCase(Locale.ROOT);
        List<String> near =
                known.stream()
                        .filter(
                                name ->
                                        distance(small, name.toLowerCase(Locale.ROOT))
                                                <= (small.length() + 1) / 4)
                        .toList();
        ToIntFunction<String> slips =
                name -> EditDistance.between(small, name.toLowerCase(Locale.ROOT));
        int least = near.stream().mapToInt(slips).min().orElse(0);
        return near.stream().filter(name -> slips.applyAsInt(name) == least).limit(3).toList();
    }

    /** "did you mean 'a' or 'b'?"; empty of no names. */
    public static Optional<String> meant(List<String> names) {
        return names.isEmpty()
                ? Optional.empty()
                : Optional.of(
                        "did you mean %s?"
                                .formatted(
                                        names.stream()
                                                .map(Names::quoted)
                                                .collect(Collectors.joining(" or "))));
    }

    /** 0 if the known one holds what was written, else their edit distance. */
    private static int distance(String unknown, String name) {
        String a = unknown.substring(0, Math.min(unknown.length(), LONGEST_COMPARED));
        return a.length() > 2 && name.contains(a) ? 0 : EditDistance.between(a, name);
    }
}
