package org.auvsim.auvsml.mapping;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
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

    /** 0 if one holds the other, else Levenshtein's edit distance. */
    private static int distance(String unknown, String name) {
        String a = unknown.substring(0, Math.min(unknown.length(), LONGEST_COMPARED));
        if (a.length() > 2 && name.contains(a)) {
            return 0;
        }
        int[] row = new int[name.length() + 1];
        for (int j = 0; j < row.length; j++) {
            row[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            int diagonal = row[0];
            row[0] = i;
            for (int j = 1; j < row.length; j++) {
                int replaced = diagonal + (a.charAt(i - 1) == name.charAt(j - 1) ? 0 : 1);
                diagonal = row[j];
                row[j] = Math.min(replaced, 1 + Math.min(row[j], row[j - 1]));
            }
        }
        return row[name.length()];
    }
}
