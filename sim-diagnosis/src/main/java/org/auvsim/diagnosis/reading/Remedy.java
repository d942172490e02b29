package org.auvsim.diagnosis.reading;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * What mends a column, with the option of {@code auvsim diagnose} that does so: whoever reads runs
 * in Java finds the same in a column mapping.
 */
final class Remedy {
    /** Stands for the name of a column that only the user knows. */
    static final String COLUMN = "COLUMN";

    /** Stands for a usual name that only the user knows. */
    static final String USUAL = "USUAL";

    private Remedy() {}

    /** Rename it to what it has: {@code (--rename letf=left)}. */
    static String renaming(String column, String usual) {
        return renaming(Map.of(column, usual));
    }

    /** The same of several: {@code (--rename T=t,X=x)}. */
    static String renaming(Map<String, String> usual) {
        return usual.keySet().stream().allMatch(c -> canBeSaid(c) && !c.contains("="))
                ? "(--rename %s)"
                        .formatted(
                                word(
                                        usual.entrySet().stream()
                                                .map(e -> e.getKey() + "=" + e.getValue())
                                                .collect(Collectors.joining(","))))
                : "(in a --mapping file: the name contains a character that is special in"
                        + " --rename)";
    }

    /** Ignore them: {@code (--ignore volt,press)}. */
    static String ignoring(List<String> columns) {
        return columns.stream().allMatch(Remedy::canBeSaid)
                ? "(--ignore %s)".formatted(word(String.join(",", columns)))
                : "(in a --mapping file: a name contains a character that is special in --ignore)";
    }

    /** Options take what is between commas for a name each. */
    private static boolean canBeSaid(String column) {
        return !column.contains(",") && !column.contains("\"");
    }

    /** As shells take it for one. */
    private static String word(String text) {
        return text.matches("[\\p{L}\\p{N}_.,:=/+-]+") ? text : "\"" + text + "\"";
    }
}
