package org.auvsim.cli;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.document.DocumentKind;
import org.auvsim.cli.report.UserError;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;

/** A run where the scenario is expected, and the scenario among the runs. */
final class SwappedFiles {
    private SwappedFiles() {}

    /** As people name the time, with a unit behind it or none: t, time_s, UTC_time, Time [s]. */
    private static final Pattern TIME =
            Pattern.compile("(?i)\"?(t|([^\\s\"]*_)?time(stamp)?)([_.][^\\s\"]*|\\s*[(\\[].*)?\"?");

    /** Refuses a table in place of a scenario; of what else is no scenario others tell. */
    static void requireScenario(Path scenario, List<Path> runs) {
        if (!isTable(scenario)) {
            return;
        }
        Optional<Path> meant = runs.stream().filter(SwappedFiles::isScenario).findFirst();
        throw new UserError(
                meant.map(
                                run ->
                                        "%s: expected a scenario, but this looks like CSV, and %s is a scenario: are they swapped? Give the scenario with --scenario, and the runs with --fit"
                                                .formatted(scenario, run))
                        .orElseGet(
                                () ->
                                        "%s: expected a scenario, but this looks like CSV; give the model with --scenario, and the measured runs with --fit"
                                                .formatted(scenario)));
    }

    /** Whether a file begins with names between commas, and one of them is that of the time. */
    private static boolean isTable(Path file) {
        try (InputStream in = Files.newInputStream(file)) {
            String text = new String(in.readNBytes(DocumentKind.BEGINNING), UTF_8);
            String line = text.lines().findFirst().orElse("").strip();
            List<String> names = List.of(line.split("\\s*[,;\t]\\s*", -1));
            return names.size() > 1 && names.stream().anyMatch(TIME.asMatchPredicate());
        } catch (IOException _) {
            return false;
        }
    }

    private static boolean isScenario(Path file) {
        try {
            return Files.isRegularFile(file) && DocumentKind.of(file) == DocumentKind.SCENARIO;
        } catch (IOException _) {
            return false;
        }
    }
}
