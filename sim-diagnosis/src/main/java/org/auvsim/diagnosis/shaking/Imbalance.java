package org.auvsim.diagnosis.shaking;

import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Numbers;
import org.auvsim.diagnosis.result.Ranked;
import org.auvsim.diagnosis.result.Sentences;
import org.auvsim.diagnosis.result.Verdict;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A propeller that is out of balance, or damaged: the body shakes more than normally, but moves as
 * its model has it. Where the motion says that something else is wrong, that may shake it, too.
 */
public final class Imbalance {
    /** Its id. */
    public static final String CAUSE = "propeller_imbalance";

    private Imbalance() {}

    /** What motion and shaking say together. */
    public static Diagnosis judged(Diagnosis byMotion, Shaking shaking) {
        if (byMotion.verdict() == Verdict.NONE && shaking.isTooMuch()) {
            return explained(byMotion, shaking);
        }
        return byMotion.noticing(List.of(notice(byMotion, shaking)));
    }

    private static String notice(Diagnosis byMotion, Shaking shaking) {
        String told =
                "the vehicle shakes %s times as much as in the %d reference runs"
                        .formatted(
                                Numbers.uncertain(shaking.factor(), shaking.deviation()),
                                shaking.references());
        String limit = Numbers.rounded(shaking.limit());
        return shaking.isTooMuch()
                ? "%s (of sound ones 1 in 100 exceeds %s); %s may shake it, or a propeller that is out of balance, too"
                        .formatted(
                                told,
                                limit,
                                byMotion.verdict() == Verdict.EXPLAINED
                                        ? "what was found"
                                        : "what is not explained")
                : "%s, which is normal: of sound ones 1 in 100 exceeds %s".formatted(told, limit);
    }

    private static Diagnosis explained(Diagnosis byMotion, Shaking shaking) {
        Quantity factor = new Quantity("factor", "1", shaking.factor());
        Finding found =
                new Finding(
                        CAUSE,
                        Optional.empty(),
                        List.of(factor),
                        List.of(shaking.deviation()),
                        0,
                        false);
        return byMotion.explained(
                found,
                Sentences.shaking(found, shaking.references()),
                ranked(byMotion.evidence().ranked(), factor, shaking.logEvidence()));
    }

    /** With the cause added to the model as it is believed. */
    private static List<Ranked> ranked(List<Ranked> byMotion, Quantity factor, double more) {
        double believed =
                byMotion.stream()
                        .filter(set -> set.causes().isEmpty())
                        .mapToDouble(Ranked::logEvidence)
                        .findFirst()
                        .orElse(Double.NEGATIVE_INFINITY);
        List<Ranked> sets = new ArrayList<>();
        sets.add(
                new Ranked(
                        List.of(CAUSE),
                        List.of(List.of(factor)),
                        believed + more,
                        0,
                        Optional.empty()));
        sets.addAll(byMotion);
        double best = sets.stream().mapToDouble(Ranked::logEvidence).max().orElse(0);
        double sum = sets.stream().mapToDouble(s -> StrictMath.exp(s.logEvidence() - best)).sum();
        return sets.stream()
                .map(
                        s ->
                                new Ranked(
                                        s.causes(),
                                        s.quantities(),
                                        s.logEvidence(),
                                        StrictMath.exp(s.logEvidence() - best) / sum,
                                        s.behind()))
                .toList();
    }
}
