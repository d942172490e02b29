package org.auvsim.experiments.scoreboard;

import org.auvsim.diagnosis.Method;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.experiments.hidden.CaseKind;

import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;

/**
 * Figures of the outcomes of one method at one noise.
 *
 * @param named of single effects: right cause first, and explained
 * @param pairs both named and nothing else
 * @param falseAlarms nulls that are not said to be none
 * @param unexplained of what no cause covers: said to be unexplained
 * @param giveUps library effects that are said to be unexplained
 * @param weak effects at 0.3 of their strength that are named
 * @param weakMissedAsNone of those that are not named: said to be none
 * @param aliasPrecision of the aliases told, those that are so
 * @param aliasRecall of the aliases that are so, those told
 * @param parameterError median of relative errors; NaN of none
 * @param expectedError what deviations that are stated lead one to expect of it; NaN of none
 * @param coverage of 95 % intervals
 * @param errorLeft median of model errors left on held-out runs, infinite if most predictions get
 *     lost; NaN of none
 * @param baselineNamed single effects that sparse regression names, and nothing else
 * @param baselinePairs pairs that it names
 * @param baselineFalseAlarms nulls in which it names something
 * @param seconds median of a diagnosis
 */
public record Scores(
        double noise,
        Method method,
        Share named,
        Share pairs,
        Share falseAlarms,
        Share unexplained,
        Share giveUps,
        Share weak,
        Share weakMissedAsNone,
        Share aliasPrecision,
        Share aliasRecall,
        double parameterError,
        double expectedError,
        Share coverage,
        double errorLeft,
        Share baselineNamed,
        Share baselinePairs,
        Share baselineFalseAlarms,
        double seconds) {
    /** Those of a method at a noise among outcomes. */
    public static Scores of(double noise, Method method, List<Outcome> all) {
        List<Outcome> at = all.stream().filter(o -> counts(noise, method, o)).toList();
        List<Outcome> singles = of(at, CaseKind.SINGLE);
        List<Outcome> pairs = of(at, CaseKind.PAIR);
        List<Outcome> nulls = of(at, CaseKind.NULL);
        List<Outcome> weak = of(at, CaseKind.WEAK);
        List<Outcome> known =
                at.stream()
                        .filter(o -> o.kind() == CaseKind.SINGLE || o.kind() == CaseKind.PAIR)
                        .toList();
        return new Scores(
                noise,
                method,
                share(singles, Outcome::isRight),
                share(pairs, Outcome::isRight),
                share(nulls, o -> !o.isRight()),
                share(of(at, CaseKind.UNCOVERED), Outcome::isRight),
                share(known, o -> o.said().verdict() == Verdict.UNEXPLAINED),
                share(weak, Outcome::isRight),
                share(
                        weak.stream().filter(o -> !o.isRight()).toList(),
                        o -> o.said().verdict() == Verdict.NONE),
                aliases(of(at, CaseKind.ALIAS), AliasTold::told),
                aliases(of(at, CaseKind.ALIAS), AliasTold::so),
                median(known.stream().flatMap(o -> o.parameterErrors().stream()).toList()),
                median(known.stream().flatMap(o -> o.expectedErrors().stream()).toList()),
                new Share(
                        known.stream().mapToInt(Outcome::covered).sum(),
                        known.stream().mapToInt(Outcome::stated).sum()),
                median(known.stream().map(Outcome::errorLeft).toList()),
                share(singles, Outcome::isBaselineRight),
                share(pairs, Outcome::isBaselineRight),
                share(nulls, o -> !o.isBaselineRight()),
                median(at.stream().map(Outcome::seconds).toList()));
    }

    private static boolean counts(double noise, Method method, Outcome outcome) {
        return outcome.noise() == noise && outcome.method() == method;
    }

    /** Whether an outcome is one of theirs. */
    boolean counts(Outcome outcome) {
        return counts(noise, method, outcome);
    }

    /** At each noise of a plan, of each method. */
    public static List<Scores> of(Plan plan, List<Outcome> all) {
        return plan.noises().stream()
                .flatMap(noise -> plan.methods().stream().map(by -> of(noise, by, all)))
                .toList();
    }

    /** What they are of, for people. */
    String title() {
        String at = String.format(Locale.ROOT, "noise %.1f %%", 100 * noise);
        return method == Method.GENETIC ? at + ", genetic" : at;
    }

    private static Share aliases(List<Outcome> outcomes, Predicate<AliasTold> among) {
        List<AliasTold> of = outcomes.stream().map(Outcome::alias).filter(among).toList();
        return new Share((int) of.stream().filter(a -> a.told() && a.so()).count(), of.size());
    }

    private static List<Outcome> of(List<Outcome> outcomes, CaseKind kind) {
        return outcomes.stream().filter(o -> o.kind() == kind).toList();
    }

    private static Share share(List<Outcome> outcomes, Predicate<Outcome> hit) {
        return new Share((int) outcomes.stream().filter(hit).count(), outcomes.size());
    }

    /** NaN of none; what is infinite is worse than all others, and is not left out. */
    static double median(List<Double> values) {
        double[] sorted = values.stream().mapToDouble(Double::doubleValue).sorted().toArray();
        int size = sorted.length;
        return size == 0 ? Double.NaN : (sorted[(size - 1) / 2] + sorted[size / 2]) / 2;
    }
}
