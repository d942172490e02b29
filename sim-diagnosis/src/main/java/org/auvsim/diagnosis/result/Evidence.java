package org.auvsim.diagnosis.result;

import java.util.List;
import java.util.Optional;

/**
 * What speaks for the causes found and against others, and what would tell more.
 *
 * @param candidates how many causes were looked for
 * @param ranked sets of causes that were tried: that of the verdict, if it has one, then the
 *     others, those of most evidence first
 * @param alternatives that explain the data about as well as those selected, the most probable
 *     first
 * @param identifiability what the data can tell apart
 * @param nextExperiment what to measure next
 */
public record Evidence(
        int candidates,
        List<Ranked> ranked,
        List<Alternative> alternatives,
        Identifiability identifiability,
        Optional<NextExperiment> nextExperiment) {
    /** The lists cannot be changed. */
    public Evidence {
        ranked = List.copyOf(ranked);
        alternatives = List.copyOf(alternatives);
    }

    /** Whether sets of causes were tried beside the model as it is believed: else nothing ranks. */
    public boolean isRanked() {
        return ranked.stream().anyMatch(set -> !set.causes().isEmpty());
    }

    /** The same, one more cause having been looked for. */
    Evidence ofOneMore(List<Ranked> sets) {
        return new Evidence(candidates + 1, sets, alternatives, identifiability, nextExperiment);
    }
}
