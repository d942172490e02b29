package org.auvsim.diagnosis.result;

import java.util.List;
import java.util.Optional;

/**
 * What measured runs say of a model in the end.
 *
 * @param verdict what it comes to
 * @param sentence the verdict for people
 * @param selected the causes found; none unless the verdict is {@link Verdict#EXPLAINED}
 * @param discrepancy what is known of a misfit that was not explained
 * @param approximation a model that does not explain the runs, but is much nearer to them
 * @param proposal a formula or field that imitates the misfit
 */
public record Conclusion(
        Verdict verdict,
        Sentence sentence,
        List<Finding> selected,
        Optional<Discrepancy> discrepancy,
        Optional<Approximation> approximation,
        Optional<Proposal> proposal) {
    /** The list cannot be changed. */
    public Conclusion {
        selected = List.copyOf(selected);
    }

    /** Where nothing is known of a misfit. */
    public Conclusion(Verdict verdict, Sentence sentence, List<Finding> selected) {
        this(verdict, sentence, selected, Optional.empty(), Optional.empty(), Optional.empty());
    }

    /** The same in other words. */
    Conclusion saying(Sentence words) {
        return judged(verdict, words, selected);
    }

    /** The same with a formula or field that imitates the misfit. */
    Conclusion proposing(Proposal other) {
        return new Conclusion(
                verdict, sentence, selected, discrepancy, approximation, Optional.of(other));
    }

    /** That nothing can be said yet, as no cause was tried. */
    Conclusion undecided() {
        return judged(Verdict.UNDECIDED, Sentences.stoppedAtOnce(), selected);
    }

    /** That a cause explains it. */
    Conclusion explained(Finding found, Sentence words) {
        return judged(Verdict.EXPLAINED, words, List.of(found));
    }

    private Conclusion judged(Verdict other, Sentence words, List<Finding> found) {
        return new Conclusion(other, words, found, discrepancy, approximation, proposal);
    }
}
