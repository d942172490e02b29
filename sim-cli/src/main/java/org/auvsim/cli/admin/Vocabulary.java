package org.auvsim.cli.admin;

import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.command.Command;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** The commands that can be said in plain words: all that the catalogue has, a user's own too. */
final class Vocabulary {
    private final List<Phrase> phrases;

    Vocabulary(MessageCatalogue catalogue) {
        phrases =
                catalogue.types().stream()
                        .filter(Command.class::isAssignableFrom)
                        .map(type -> Phrase.of(catalogue, type))
                        .sorted(Comparator.comparing(Phrase::text))
                        .toList();
    }

    /** All phrases, in the order of their words. */
    List<Phrase> phrases() {
        return phrases;
    }

    /** A phrase that words begin with, and how many of the words it takes. */
    record Said(Phrase phrase, int words) {}

    /**
     * The longest phrase that words begin with. Its own words may also be joined by hyphens, or be
     * the whole name of the element.
     */
    Optional<Said> in(List<String> words) {
        Optional<Said> longest = Optional.empty();
        for (int count = 1; count <= words.size(); count++) {
            String said = String.join("-", words.subList(0, count));
            for (Phrase phrase : phrases) {
                if (said.equals(phrase.text().replace(' ', '-')) || said.equals(phrase.element())) {
                    longest = Optional.of(new Said(phrase, count));
                }
            }
        }
        return longest;
    }

    /** The phrases that begin with these words; the last of them may be unfinished. */
    List<Phrase> beginningWith(String words) {
        return phrases.stream().filter(phrase -> phrase.text().startsWith(words)).toList();
    }
}
