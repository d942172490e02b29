package org.auvsim.experiments.scoreboard;

import org.auvsim.diagnosis.Method;
import org.auvsim.diagnosis.result.Alternative;
import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.experiments.hidden.HiddenCase;
import org.auvsim.experiments.hidden.HiddenEffect;
import org.auvsim.experiments.hidden.Twins;

import java.util.ArrayList;
import java.util.List;

/** Compares a diagnosis with what is hidden. */
final class Referee {
    private Referee() {}

    static Outcome outcome(
            HiddenCase of,
            Method method,
            Diagnosis diagnosis,
            List<String> baseline,
            double seconds) {
        boolean explained = diagnosis.verdict() == Verdict.EXPLAINED;
        List<Finding> selected = diagnosis.selected();
        List<Double> errors = new ArrayList<>();
        List<Double> expected = new ArrayList<>();
        int covered = 0;
        int stated = 0;
        int hits = 0;
        for (HiddenEffect effect : of.hidden()) {
            for (Finding finding : selected) {
                if (of.isHit(effect, finding)) {
                    ParameterCheck check = ParameterCheck.of(effect.parameters(), finding);
                    errors.addAll(check.errors());
                    expected.addAll(check.expected());
                    covered += check.covered();
                    stated += check.stated();
                    hits++;
                }
            }
        }
        boolean first =
                explained && of.hidden().stream().anyMatch(e -> of.isHit(e, strongest(selected)));
        boolean exact =
                explained && hits == of.hidden().size() && selected.size() == of.hidden().size();
        return new Outcome(
                method,
                of.kind(),
                of.noise(),
                of.seed(),
                of.body(),
                of.hidden().stream().map(HiddenEffect::name).toList(),
                new Answer(diagnosis.verdict(), selected.stream().map(Finding::name).toList()),
                first,
                exact,
                errors,
                expected,
                covered,
                stated,
                of.hidden().isEmpty() ? Double.NaN : errorLeft(of, diagnosis),
                alias(of, diagnosis),
                baseline,
                isRight(of, baseline),
                seconds,
                method == Method.GENETIC ? of.repeat() + " --genetic 1" : of.repeat());
    }

    private static AliasTold alias(HiddenCase of, Diagnosis diagnosis) {
        return of.twins()
                .map(twins -> new AliasTold(twins.areAlike(), isTold(twins, diagnosis)))
                .orElse(AliasTold.NONE);
    }

    /** One is selected, and the other one told as what could not be told apart from it. */
    private static boolean isTold(Twins twins, Diagnosis diagnosis) {
        List<String> selected = diagnosis.selected().stream().map(Finding::cause).toList();
        List<String> others =
                diagnosis.evidence().alternatives().stream()
                        .filter(Alternative::isIndistinguishable)
                        .flatMap(a -> a.causes().stream())
                        .toList();
        return (among(twins.first(), selected) && among(twins.second(), others))
                || (among(twins.second(), selected) && among(twins.first(), others));
    }

    /** Names begin with the cause's id. */
    private static boolean among(String cause, List<String> names) {
        return names.stream().anyMatch(n -> n.equals(cause) || n.startsWith(cause + " ("));
    }

    /** That without which the misfit grows most. */
    private static Finding strongest(List<Finding> selected) {
        Finding strongest = selected.getFirst();
        for (Finding finding : selected) {
            strongest = finding.share() > strongest.share() ? finding : strongest;
        }
        return strongest;
    }

    private static boolean isRight(HiddenCase of, List<String> causes) {
        List<String> hidden = of.hidden().stream().map(HiddenEffect::name).toList();
        return causes.size() == hidden.size() && causes.containsAll(hidden);
    }

    private static double errorLeft(HiddenCase of, Diagnosis diagnosis) {
        double before = 0;
        double after = 0;
        int run = 0;
        for (DiagnosedRun diagnosed : diagnosis.runs()) {
            if (diagnosed.isHeldOut()) {
                before += Math.pow(of.error(run, diagnosed.before()), 2);
                after += Math.pow(of.error(run, diagnosed.after()), 2);
                run++;
            }
        }
        return left(before, after);
    }

    /** Of squared errors: what is lost now is not excused by having been lost before. */
    static double left(double before, double after) {
        return Double.isInfinite(after) ? after : Math.sqrt(after / before);
    }
}
