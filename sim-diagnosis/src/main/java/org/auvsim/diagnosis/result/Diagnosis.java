package org.auvsim.diagnosis.result;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.diagnosis.run.Channel;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * What measured runs say of a model.
 *
 * @param sentence the verdict for people
 * @param body the measured body's name
 * @param selected the causes found; none unless the verdict is {@link Verdict#EXPLAINED}
 * @param candidates how many causes were looked for
 * @param ranked sets of causes that were tried: that of the verdict, if it has one, then the
 *     others, those of most evidence first
 * @param alternatives that explain the data about as well as those selected, the most probable
 *     first
 * @param noise standard deviation of each channel that was measured
 * @param heldOut error on held-out runs by channel
 * @param horizons the same, by how far ahead is predicted
 * @param usedHeldOut whether held-out runs had to be used for the search, too: the gain is then
 *     that of leaving each run out in turn
 * @param runs fitted and held-out, with the model's motion before and after
 * @param discrepancy what is known of a misfit that was not explained
 * @param approximation a model that does not explain the runs, but is much nearer to them
 * @param proposal a formula or field that imitates it
 * @param nextExperiment what to measure next
 * @param extended the model with what was found
 * @param notices what was done to the data, and what limits the verdict
 * @param seed with which it can be repeated
 * @param isComplete whether the search came to its end, or was stopped with the best so far
 */
public record Diagnosis(
        Verdict verdict,
        String sentence,
        String body,
        List<Finding> selected,
        int candidates,
        List<Ranked> ranked,
        List<Alternative> alternatives,
        Map<Channel, Double> noise,
        Map<Channel, Gain> heldOut,
        List<HorizonGain> horizons,
        boolean usedHeldOut,
        List<DiagnosedRun> runs,
        Optional<Discrepancy> discrepancy,
        Optional<Approximation> approximation,
        Optional<Proposal> proposal,
        Optional<NextExperiment> nextExperiment,
        Identifiability identifiability,
        Scenario extended,
        List<String> notices,
        long seed,
        boolean isComplete) {
    /** The lists cannot be changed. */
    public Diagnosis {
        selected = List.copyOf(selected);
        ranked = List.copyOf(ranked);
        alternatives = List.copyOf(alternatives);
        noise = Collections.unmodifiableSortedMap(new TreeMap<>(noise));
        heldOut = Collections.unmodifiableSortedMap(new TreeMap<>(heldOut));
        horizons = List.copyOf(horizons);
        runs = List.copyOf(runs);
        notices = List.copyOf(notices);
    }

    /** The same, said of a search that was stopped before its end, if it was. */
    public Diagnosis toldAsFarAsItCame() {
        if (isComplete) {
            return this;
        }
        return isUntried()
                ? with(
                        Verdict.UNDECIDED,
                        Sentence.stoppedAtOnce(),
                        selected,
                        candidates,
                        ranked,
                        proposal,
                        notices)
                : with(Sentence.stopped(sentence), proposal, notices);
    }

    /** Whether it was stopped before any cause was tried: then nothing in it tells anything. */
    public boolean isUntried() {
        return !isComplete && ranked.stream().allMatch(set -> set.causes().isEmpty());
    }

    /** The same, only some of the causes that are known having been looked for. */
    public Diagnosis ofSomeCauses() {
        return with(Sentence.ofSome(sentence), proposal, notices);
    }

    /** The same of runs whose numbers may not be what they are taken for, as notices say. */
    public Diagnosis doubted() {
        return with(Sentence.doubted(sentence), proposal, notices);
    }

    /** The same with a formula or field that imitates the misfit. */
    public Diagnosis proposing(Proposal other) {
        return with(sentence, Optional.of(other), notices);
    }

    /** The same with notices before its own: what reading the runs had to say. */
    public Diagnosis noticing(List<String> more) {
        List<String> all = new ArrayList<>(more);
        all.addAll(notices);
        return with(sentence, proposal, all);
    }

    /** The same with a cause that changes nothing of the motion, where that lacks nothing. */
    public Diagnosis explained(Finding found, String words, List<Ranked> sets) {
        return with(
                Verdict.EXPLAINED, words, List.of(found), candidates + 1, sets, proposal, notices);
    }

    private Diagnosis with(String said, Optional<Proposal> proposed, List<String> noticed) {
        return with(verdict, said, selected, candidates, ranked, proposed, noticed);
    }

    private Diagnosis with(
            Verdict judged,
            String words,
            List<Finding> found,
            int lookedFor,
            List<Ranked> sets,
            Optional<Proposal> proposed,
            List<String> noticed) {
        return new Diagnosis(
                judged,
                words,
                body,
                found,
                lookedFor,
                sets,
                alternatives,
                noise,
                heldOut,
                horizons,
                usedHeldOut,
                runs,
                discrepancy,
                approximation,
                proposed,
                nextExperiment,
                identifiability,
                extended,
                noticed,
                seed,
                isComplete);
    }
}
