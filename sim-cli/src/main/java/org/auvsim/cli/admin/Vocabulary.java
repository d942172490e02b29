package org.auvsim.cli.admin;

import org.auvsim.auvsml.mapping.EditDistance;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.command.Command;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/** The commands that can be said in plain words: all that the catalogue has, a user's own too. */
final class Vocabulary {
    /** A phrase is near if no more than one letter in so many is another one. */
    private static final int LETTERS_A_SLIP = 3;

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

    /** The phrase that the beginning of these words comes nearest to; empty if none is near. */
    Optional<Phrase> nearest(List<String> words) {
        Comparator<Phrase> byDistance = Comparator.comparingInt(p -> distance(p, words));
        return phrases.stream()
                .min(byDistance)
                .filter(
                        phrase ->
                                distance(phrase, words) * LETTERS_A_SLIP <= phrase.text().length());
    }

    private static int distance(Phrase phrase, List<String> words) {
        int count = phrase.text().split(" ", -1).length;
        String said = String.join(" ", words.subList(0, Math.min(count, words.size())));
        return EditDistance.between(said, phrase.text());
    }

    /** The phrases that begin with these words; the last of them may be unfinished. */
    List<Phrase> beginningWith(String words) {
        return phrases.stream().filter(phrase -> phrase.text().startsWith(words)).toList();
    }
}
