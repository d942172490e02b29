package org.auvsim.cli.admin;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.Fault;
import org.auvsim.auvsml.framing.AuvsmlReader;
import org.auvsim.auvsml.framing.Incoming;
import org.auvsim.auvsml.framing.RootDecoder;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.mapping.Part;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.xml.Limits;
import org.auvsim.cli.report.FileTrouble;
import org.auvsim.cli.report.UserError;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;

/** Turns a line of plain words, or of AUVSML, into messages. */
final class Interpreter {
    /** Attributes for which the name of a world object may stand in place of its id. */
    static final Set<String> IDS = Set.of("world-object-id", "agent-id", "entity-id");

    /** A scenario that is to be loaded may be long; the server says if it is too long for it. */
    private static final Limits LIMITS = Limits.SCENARIO;

    private static final int MOST_SUGGESTED = 8;

    private final Vocabulary vocabulary;
    private final KnownNames names;
    private final RootDecoder decoder;

    Interpreter(MessageCatalogue catalogue, Vocabulary vocabulary, KnownNames names) {
        this.vocabulary = vocabulary;
        this.names = names;
        this.decoder = RootDecoder.strict(catalogue, LIMITS);
    }

    /**
     * The messages that a line means.
     *
     * @throws UserError if it means nothing, with what was expected
     */
    List<Message> messages(String line) {
        Words words = Words.of(line);
        if (words.words().isEmpty()) {
            return decode(
                    isRoot(words.xml()) ? words.xml() : "<auvsml>" + words.xml() + "</auvsml>",
                    Fault::sentence);
        }
        Vocabulary.Said said =
                vocabulary.in(words.words()).orElseThrow(() -> unknown(words.words()));
        List<String> values = words.words().subList(said.words(), words.words().size());
        return decode(
                "<auvsml>" + element(said.phrase(), values, words.xml()) + "</auvsml>",
                Interpreter::withoutPath);
    }

    /** What is wrong, with the name of the value instead of a path that nobody has typed. */
    private static String withoutPath(Fault fault) {
        String name = fault.path().substring(fault.path().indexOf('@') + 1);
        return fault.path().contains("@") && !fault.problem().contains(name)
                ? name + ": " + fault.problem()
                : fault.problem();
    }

    private static boolean isRoot(String xml) {
        return xml.startsWith("<?xml")
                || MessageCatalogue.roots().stream().anyMatch(root -> xml.startsWith("<" + root));
    }

    private UserError unknown(List<String> words) {
        String first = words.getFirst();
        Optional<Phrase> nearest =
                words.size() == 1 && !vocabulary.beginningWith(first).isEmpty()
                        ? Optional.empty()
                        : vocabulary.nearest(words);
        if (nearest.isPresent()) {
            return new UserError(
                    "There is no command '%s'; the nearest is '%s', and 'help' lists all."
                            .formatted(String.join(" ", words), nearest.get().text()));
        }
        String near =
                vocabulary.beginningWith(first).stream()
                        .limit(MOST_SUGGESTED)
                        .map(phrase -> "'" + phrase.text() + "'")
                        .collect(Collectors.joining(", "));
        return new UserError(
                near.isEmpty()
                        ? "There is no command '%s'; 'help' lists all.".formatted(first)
                        : "There is no command '%s'; there is %s."
                                .formatted(String.join(" ", words), near));
    }

    private String element(Phrase phrase, List<String> values, String xml) {
        Map<String, String> attributes = new LinkedHashMap<>();
        StringBuilder inside = new StringBuilder();
        List<Part> open = new ArrayList<>(phrase.attributes());
        for (String value : values) {
            int equals = value.indexOf('=');
            if (value.startsWith("@")) {
                inside.append(contents(value.substring(1)));
            } else if (equals > 0 && isPart(phrase, value.substring(0, equals))) {
                String name = value.substring(0, equals);
                open.removeIf(part -> part.name().equals(name));
                attributes.put(name, id(name, value.substring(equals + 1)));
            } else if (open.isEmpty()) {
                throw new UserError(
                        "'%s' is one word too many: %s".formatted(value, phrase.usage()));
            } else {
                String name = open.removeFirst().name();
                attributes.put(name, id(name, value));
            }
        }
        boolean isWhole =
                open.stream().noneMatch(Part::isRequired)
                        && (phrase.parts().stream()
                                        .noneMatch(part -> !part.isAttribute() && part.isRequired())
                                || !inside.isEmpty()
                                || !xml.isEmpty());
        if (!isWhole) {
            throw new UserError("Something is missing: " + phrase.usage());
        }
        return element(phrase.element(), attributes, inside + xml);
    }

    private static String element(String name, Map<String, String> attributes, String inside) {
        StringBuilder element = new StringBuilder("<").append(name);
        attributes.forEach(
                (attribute, value) ->
                        element.append(' ')
                                .append(attribute)
                                .append("=\"")
                                .append(escaped(value))
                                .append('"'));
        return element.append('>').append(inside).append("</").append(name).append('>').toString();
    }

    private static boolean isPart(Phrase phrase, String name) {
        return phrase.attributes().stream().anyMatch(part -> part.name().equals(name));
    }

    private String id(String attribute, String value) {
        return IDS.contains(attribute) ? Long.toString(names.id(value)) : value;
    }

    private static String escaped(String value) {
        return value.replace("&", "&amp;").replace("<", "&lt;").replace("\"", "&quot;");
    }

    private static String contents(String file) {
        try {
            return Files.readString(Path.of(file)).replaceFirst("^\\s*<\\?xml[^>]*\\?>", "");
        } catch (InvalidPathException e) {
            throw new UserError("'%s' is no path of a file.".formatted(file), e);
        } catch (IOException e) {
            throw FileTrouble.reading(Path.of(file), e);
        }
    }

    private List<Message> decode(String xml, Function<Fault, String> told) {
        List<Message> messages = new ArrayList<>();
        AuvsmlReader reader =
                new AuvsmlReader(new ByteArrayInputStream(xml.getBytes(UTF_8)), decoder, LIMITS);
        try {
            for (Incoming next = reader.next(); !(next instanceof Incoming.End); ) {
                switch (next) {
                    case Incoming.Request request -> messages.addAll(request.messages());
                    case Incoming.Rejected rejected ->
                            throw new UserError(told.apply(rejected.fault()));
                    case Incoming.End _ -> throw new AssertionError("it ends the loop");
                }
                next = reader.next();
            }
        } catch (IOException e) {
            throw new UncheckedIOException("a text in memory cannot fail to be read", e);
        }
        return messages;
    }
}
