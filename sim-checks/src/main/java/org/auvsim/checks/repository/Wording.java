package org.auvsim.checks.repository;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Finds what no tracked file may say. */
final class Wording {
    private static final Map<String, Pattern> FORBIDDEN =
            Map.of(
                    "somebody's home folder",
                    Pattern.compile("/(?:home|Users|root)/\\w|[A-Z]:\\\\+Users\\\\"),
                    "work left undone",
                    Pattern.compile("\\b(?:TO" + "DO|FIX" + "ME|XX" + "X)\\b"));

    private Wording() {}

    /** A sentence for each find in a file. */
    static List<String> offences(Path root, Path file) throws IOException {
        byte[] bytes = Files.readAllBytes(root.resolve(file));
        String text = new String(bytes, UTF_8);
        List<String> found = new ArrayList<>();
        FORBIDDEN.forEach(
                (what, pattern) -> {
                    Matcher matcher = pattern.matcher(text);
                    while (matcher.find()) {
                        found.add(place(file, text, matcher.start()) + " names " + what);
                    }
                });
        return found;
    }

    private static String place(Path file, String text, int offset) {
        return file + ":" + (1 + text.substring(0, offset).chars().filter(c -> c == '\n').count());
    }
}
