package org.auvsim.cli.admin;

import org.auvsim.auvsml.mapping.Part;
import org.auvsim.cli.report.UserError;
import org.jline.reader.Candidate;
import org.jline.reader.Completer;
import org.jline.reader.LineReader;
import org.jline.reader.ParsedLine;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** Completes words of commands, names of world objects, values and elements. */
final class Completion implements Completer {
    private static final String HELP = "help";

    private final Vocabulary vocabulary;
    private final KnownNames names;

    Completion(Vocabulary vocabulary, KnownNames names) {
        this.vocabulary = vocabulary;
        this.names = names;
    }

    @Override
    public void complete(LineReader reader, ParsedLine line, List<Candidate> candidates) {
        List<String> before = line.words().subList(0, line.wordIndex());
        boolean helps = !before.isEmpty() && before.getFirst().equals(HELP);
        List<String> command = helps ? before.subList(1, before.size()) : before;
        Stream<String> next =
                Stream.concat(nextWords(command), helps ? Stream.of() : values(command));
        if (before.isEmpty()) {
            next = Stream.concat(next, Stream.of(HELP, "exit"));
        }
        next.distinct().forEach(word -> candidates.add(new Candidate(word)));
    }

    /** The words that may follow in a phrase. */
    private Stream<String> nextWords(List<String> words) {
        String said = words.isEmpty() ? "" : String.join(" ", words) + " ";
        return vocabulary.beginningWith(said).stream()
                .map(phrase -> phrase.text().substring(said.length()).split(" ", 2)[0]);
    }

    /** What may follow as the next value of a command. */
    private Stream<String> values(List<String> words) {
        Optional<Vocabulary.Said> said = vocabulary.in(words);
        if (said.isEmpty()) {
            return Stream.of();
        }
        Phrase phrase = said.get().phrase();
        List<String> given = words.subList(said.get().words(), words.size());
        List<Part> attributes = phrase.attributes();
        if (given.size() < attributes.size()) {
            Part next = attributes.get(given.size());
            return Stream.concat(next.choices().stream(), known(phrase, next, given));
        }
        return phrase.parts().stream()
                .filter(part -> !part.isAttribute())
                .flatMap(part -> part.choices().stream())
                .map(element -> "<" + element);
    }

    private Stream<String> known(Phrase phrase, Part attribute, List<String> given) {
        try {
            return names.of(phrase.element(), attribute.name(), given);
        } catch (UserError _) {
            return Stream.of(); // the command itself tells what is wrong
        }
    }
}
