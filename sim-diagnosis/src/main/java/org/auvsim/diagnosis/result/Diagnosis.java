package org.auvsim.diagnosis.result;

import org.auvsim.auvsml.document.Scenario;

import java.util.ArrayList;
import java.util.List;

/**
 * What measured runs say of a model.
 *
 * @param body the measured body's name
 * @param conclusion what it comes to
 * @param evidence what speaks for that, and what would tell more
 * @param prediction how well held-out runs are predicted
 * @param runs fitted and held-out, with the model's motion before and after
 * @param extended the model with what was found
 * @param notices what was done to the data, and what limits the verdict
 * @param seed with which it can be repeated
 * @param isComplete whether the search came to its end, or was stopped with the best so far
 */
public record Diagnosis(
        String body,
        Conclusion conclusion,
        Evidence evidence,
        Prediction prediction,
        List<DiagnosedRun> runs,
        Scenario extended,
        List<String> notices,
        long seed,
        boolean isComplete) {
    /** The lists cannot be changed. */
    public Diagnosis {
        runs = List.copyOf(runs);
        notices = List.copyOf(notices);
    }

    /** What it comes to. */
    public Verdict verdict() {
        return conclusion.verdict();
    }

    /** The verdict for people. */
    public String sentence() {
        return conclusion.sentence().text();
    }

    /** The causes found; none unless the verdict is {@link Verdict#EXPLAINED}. */
    public List<Finding> selected() {
        return conclusion.selected();
    }

    /** Whether it was stopped before any cause was tried: then nothing in it tells anything. */
    public boolean isUntried() {
        return !isComplete && !evidence.isRanked();
    }

    /** The same, said of a search that was stopped before its end, if it was. */
    public Diagnosis toldAsFarAsItCame() {
        if (isComplete) {
            return this;
        }
        return isUntried() ? with(conclusion.undecided()) : saying(conclusion.sentence().stopped());
    }

    /** The same, only some of the causes that are known having been looked for. */
    public Diagnosis ofSomeCauses() {
        return saying(conclusion.sentence().ofSome());
    }

    /** The same of runs whose numbers may not be what they are taken for, as notices say. */
    public Diagnosis doubted() {
        return saying(conclusion.sentence().doubted());
    }

    /** The same with a formula or field that imitates the misfit. */
    public Diagnosis proposing(Proposal other) {
        return with(conclusion.proposing(other));
    }

    /** The same with a cause that changes nothing of the motion, where that lacks nothing. */
    public Diagnosis explained(Finding found, Sentence words, List<Ranked> sets) {
        return with(conclusion.explained(found, words), evidence.ofOneMore(sets), notices);
    }

    /** The same with notices before its own: what reading the runs had to say. */
    public Diagnosis noticing(List<String> more) {
        List<String> all = new ArrayList<>(more);
        all.addAll(notices);
        return with(conclusion, evidence, all);
    }

    private Diagnosis saying(Sentence words) {
        return with(conclusion.saying(words));
    }

    private Diagnosis with(Conclusion other) {
        return with(other, evidence, notices);
    }

    private Diagnosis with(Conclusion concluded, Evidence weighed, List<String> noticed) {
        return new Diagnosis(
                body, concluded, weighed, prediction, runs, extended, noticed, seed, isComplete);
    }
}
