package org.auvsim.junit;

import static org.auvsim.junit.Figures.text;

import java.util.List;

/**
 * What is wrong with a trajectory.
 *
 * @param verb what the body does, as "leaves the box"
 * @param at the body then
 * @param actual what was found, as "z = -3.2 m"
 * @param expected what was not, as "allowed -3 to 0 m"
 * @param beside the other bodies that it is about
 */
record Finding(String verb, Sample at, String actual, String expected, List<Trajectory> beside) {
    Finding {
        beside = List.copyOf(beside);
    }

    /** About one body alone. */
    Finding(String verb, Sample at, String actual, String expected) {
        this(verb, at, actual, expected, List.of());
    }

    /** The sentence without its full stop. */
    String sentence(String name) {
        return "'%s' %s at %s s: %s, %s".formatted(name, verb, text(at.time()), actual, expected);
    }
}
