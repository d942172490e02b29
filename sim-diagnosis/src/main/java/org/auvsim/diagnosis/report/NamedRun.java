package org.auvsim.diagnosis.report;

import org.auvsim.diagnosis.result.DiagnosedRun;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/**
 * A run and the name of its tables.
 *
 * @param name of a file, with its ending
 */
record NamedRun(DiagnosedRun run, String name) {
    private static final String ENDING = ".csv";

    /** Runs with names that any system takes and that differ, also where case does not count. */
    static List<NamedRun> of(List<DiagnosedRun> runs) {
        Set<String> taken = new HashSet<>();
        List<NamedRun> files = new ArrayList<>();
        for (DiagnosedRun run : runs) {
            String plain = plain(run.run().name());
            String name = plain;
            for (int i = 2; !taken.add(name.toLowerCase(Locale.ROOT)); i++) {
                name = plain + "-" + i;
            }
            files.add(new NamedRun(run, name + ENDING));
        }
        return files;
    }

    private static String plain(String name) {
        String stem =
                name.toLowerCase(Locale.ROOT).endsWith(ENDING)
                        ? name.substring(0, name.length() - ENDING.length())
                        : name;
        String plain = stem.replaceAll("[^A-Za-z0-9._-]+", "_").replaceFirst("^[.]+", "_");
        return plain.isEmpty() ? "run" : plain;
    }
}
