package org.auvsim.experiments.scoreboard;

import org.auvsim.diagnosis.result.Verdict;

import java.util.List;

/**
 * What a method says of a case.
 *
 * @param causes names of those that it selected
 */
public record Answer(Verdict verdict, List<String> causes) {
    /** The list cannot be changed. */
    public Answer {
        causes = List.copyOf(causes);
    }
}
