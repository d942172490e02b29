package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.result.Ranked;
import org.auvsim.diagnosis.search.Alternatives;
import org.auvsim.diagnosis.search.Search;
import org.auvsim.diagnosis.search.Told;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Sets of causes by how well they explain the runs. */
public final class Ranking {
    private Ranking() {}

    /**
     * All that were tried: first that of the verdict, if it has one, then the others, those of most
     * evidence first: a score also has the price of many tries, which evidence has not. What was
     * chosen is not always that of the largest evidence (a specific cause stands before one that
     * can imitate others, a common one before what the data cannot tell from it).
     *
     * @param isOfVerdict whether the best is what the verdict names; else it is only what comes
     *     nearest, and stands where its evidence has it
     */
    public static List<Ranked> of(Search.Found found, boolean isOfVerdict) {
        List<Judged> fitted =
                found.judged().stream()
                        .filter(j -> found.judged().stream().noneMatch(j::isBehind))
                        .sorted(Comparator.comparingDouble(Judged::logEvidence).reversed())
                        .toList();
        double most = fitted.stream().mapToDouble(Judged::logEvidence).max().orElseThrow();
        double sum = 0;
        for (Judged judged : fitted) {
            sum += StrictMath.exp(judged.logEvidence() - most);
        }
        List<Ranked> ranked = new ArrayList<>();
        for (Judged judged : fitted) {
            boolean isBest = causes(judged).equals(causes(found.best()));
            ranked.add(
                    isBest && isOfVerdict ? 0 : ranked.size(),
                    ranked(
                            judged,
                            StrictMath.exp(judged.logEvidence() - most) / sum,
                            isBest ? Optional.empty() : behind(judged, found)));
        }
        return ranked;
    }

    private static Set<Object> causes(Judged of) {
        return Set.copyOf(of.fit().hypothesis().causes());
    }

    /** Why one was not chosen whose evidence is larger than that of what was. */
    private static Optional<String> behind(Judged other, Search.Found found) {
        Judged chosen = found.best();
        return other.logEvidence() > chosen.logEvidence()
                ? Optional.of(reason(other, chosen))
                : Optional.empty();
    }

    private static String reason(Judged other, Judged chosen) {
        Hypothesis of = other.fit().hypothesis();
        Hypothesis best = chosen.fit().hypothesis();
        if (other.score() > chosen.score()) {
            return "its gain is too small, given how many sets were tried";
        }
        if (chosen.isNone()) {
            return "held-out runs do not confirm it, or noise alone could gain as much";
        }
        if (of.isGeneric() && !best.isGeneric()) {
            return "it can imitate other causes";
        }
        if (Alternatives.areSame(other, chosen)) {
            return "it predicts the same within the noise, and its cause is less common";
        }
        if (chosen.isWhite() && !other.isWhite()) {
            return "its residuals are more than noise";
        }
        return "not clearly better, and leave-one-out prediction does not favour it";
    }

    private static Ranked ranked(Judged judged, double probability, Optional<String> behind) {
        Hypothesis of = judged.fit().hypothesis();
        List<String> names = new ArrayList<>();
        List<List<Quantity>> quantities = new ArrayList<>();
        for (int c = 0; c < of.causes().size(); c++) {
            names.add(of.causes().get(c).label());
            quantities.add(Told.of(of.causes().get(c), of.theta().get(c)));
        }
        return new Ranked(names, quantities, judged.logEvidence(), probability, behind);
    }
}
