package org.auvsim.diagnosis.result;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** How much was tried for a verdict: one of many that were compared says more than one of few. */
public final class Effort {
    private static final int MOST = 3;

    /** Logarithms of evidence that differ by less tell nothing (Kass and Raftery 1995). */
    private static final double ALIKE = 1;

    private Effort() {}

    /**
     * In words: {@code Causes looked for: 62; sets of them that were fitted: 23}. What promises no
     * more than noise would is not fitted. The most probable of sets need not explain anything.
     */
    public static String words(Diagnosis of) {
        long sets = of.evidence().ranked().stream().filter(set -> !set.causes().isEmpty()).count();
        if (of.isComplete() && sets == 0) {
            return "Causes looked for: %d; none of them promised enough to be fitted"
                    .formatted(of.evidence().candidates());
        }
        String form =
                of.isComplete()
                        ? "Causes looked for: %d; sets of them that were fitted: %d"
                        : "Causes to be looked for: %d; sets of them that were fitted before the"
                                + " search was stopped: %d";
        String tried = form.formatted(of.evidence().candidates(), sets);
        return of.verdict() == Verdict.UNEXPLAINED && sets > 0
                ? tried + ", none of which explains the runs"
                : tried;
    }

    /**
     * Why sets with more evidence than what was chosen were not, if there are any; where nothing
     * was, why errors and residuals are not of them.
     */
    public static Optional<String> behind(Diagnosis of) {
        Map<String, List<String>> byReason = new LinkedHashMap<>();
        for (Ranked set : of.evidence().ranked()) {
            set.behind()
                    .ifPresent(
                            reason ->
                                    byReason.computeIfAbsent(reason, _ -> new ArrayList<>())
                                            .add(set.name()));
        }
        return byReason.isEmpty()
                ? Optional.empty()
                : Optional.of(
                        byReason.entrySet().stream()
                                .map(e -> "%s (%s)".formatted(list(e.getValue()), e.getKey()))
                                .collect(Collectors.joining("; ", heading(of), ".")));
    }

    private static String heading(Diagnosis of) {
        if (of.verdict() == Verdict.UNEXPLAINED) {
            return ofNearest(of);
        }
        return evidence(of, true) - evidence(of, false) < ALIKE
                ? "Not chosen, though about as probable: "
                : "Not chosen despite higher evidence: ";
    }

    /** The largest logarithm of sets that are behind others, or of those that are not. */
    private static double evidence(Diagnosis of, boolean isBehind) {
        return of.evidence().ranked().stream()
                .filter(set -> set.behind().isPresent() == isBehind)
                .mapToDouble(Ranked::logEvidence)
                .max()
                .orElseThrow();
    }

    /** Where none of them explains the runs, what is left is told of the one that comes nearest. */
    private static String ofNearest(Diagnosis of) {
        return "Errors and residuals are those %s, despite higher evidence not with "
                .formatted(
                        of.evidence().ranked().stream()
                                .filter(set -> set.behind().isEmpty())
                                .findFirst()
                                .map(
                                        set ->
                                                set.causes().isEmpty()
                                                        ? "of the model as believed"
                                                        : "with " + set.name())
                                .orElseThrow());
    }

    private static String list(List<String> names) {
        int more = names.size() - MOST;
        String some = names.stream().limit(MOST).collect(Collectors.joining(", "));
        return more > 0 ? "%s and %d more".formatted(some, more) : some;
    }
}
