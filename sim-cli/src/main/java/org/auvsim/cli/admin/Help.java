package org.auvsim.cli.admin;

import org.auvsim.cli.report.UserError;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** What the commands are for: the reference of the messages, in the shell. */
final class Help {
    private static final String REFERENCE = "auvsml.md";
    private static final String SECTION = "### ";

    private final Vocabulary vocabulary;
    private final Map<String, String> sections;

    /** For these commands; those of a user's own that no reference has are told by their usage. */
    Help(Vocabulary vocabulary) {
        this.vocabulary = vocabulary;
        this.sections = sections(reference());
    }

    private static String reference() {
        try (InputStream in = Help.class.getResourceAsStream(REFERENCE)) {
            if (in == null) {
                throw new IllegalStateException(REFERENCE + " is missing from the program");
            }
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** What stands below each heading of an element. */
    private static Map<String, String> sections(String reference) {
        Map<String, List<String>> lines = new LinkedHashMap<>();
        List<String> section = new ArrayList<>();
        for (String line : reference.lines().toList()) {
            if (line.startsWith("#")) {
                section = new ArrayList<>();
                if (line.startsWith(SECTION)) {
                    lines.put(line.substring(SECTION.length()), section);
                }
            } else {
                plain(line).ifPresent(section::add);
            }
        }
        Map<String, String> texts = new LinkedHashMap<>();
        lines.forEach((element, of) -> texts.put(element, String.join("\n", of).strip()));
        return texts;
    }

    /** A line without Markdown; empty if it is nothing but that. */
    private static Optional<String> plain(String line) {
        String text = line.replaceAll("\\[([^\\]]*)]\\([^)]*\\)", "$1").replace("`", "");
        if (line.startsWith("```") || line.startsWith("|---") || line.startsWith("| part |")) {
            return Optional.empty();
        }
        return Optional.of(
                text.startsWith("|")
                        ? text.replaceAll("^\\| | *\\|$", "  ").replace(" | ", "  ").stripTrailing()
                        : text);
    }

    /**
     * Help on a command, or on all if none is named.
     *
     * @throws UserError if there is none of these words
     */
    String on(String words) {
        if (words.isEmpty()) {
            return all();
        }
        List<Phrase> found = vocabulary.beginningWith(words);
        if (found.isEmpty()) {
            throw new UserError("There is no command '%s'; 'help' lists all.".formatted(words));
        }
        return found.stream()
                .filter(phrase -> found.size() == 1 || phrase.text().equals(words))
                .findFirst()
                .map(phrase -> phrase.usage() + "\n\n" + section(phrase))
                .orElseGet(() -> list(found));
    }

    private String all() {
        return list(vocabulary.phrases())
                + "\n\n"
                + """
                help COMMAND tells more. Values stand in the order shown, or as name=value; the name of a
                world object may stand for its id; "two words" belong together; elements are written as in
                AUVSML, or read from a file: @FILE. A line that begins with < is AUVSML. exit leaves.\
                """;
    }

    private String list(List<Phrase> phrases) {
        return phrases.stream()
                .map(phrase -> "%-30s %s".formatted(phrase.text(), summary(phrase)))
                .map(String::stripTrailing)
                .collect(Collectors.joining("\n"));
    }

    private String summary(Phrase phrase) {
        String text = section(phrase);
        int end = text.indexOf('\n');
        return end < 0 ? text : text.substring(0, end);
    }

    private String section(Phrase phrase) {
        return sections.getOrDefault(phrase.element(), "");
    }
}
