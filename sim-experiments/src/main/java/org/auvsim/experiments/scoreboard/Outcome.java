package org.auvsim.experiments.scoreboard;

import org.auvsim.diagnosis.Method;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.experiments.hidden.CaseKind;

import java.util.List;

/**
 * What a diagnosis made of a case.
 *
 * @param method by which causes were searched for
 * @param hidden names of the effects
 * @param said by the diagnosis
 * @param first cause that it ranks highest of those selected is hidden, and it says explained
 * @param exact it says explained, and names what is hidden and nothing else
 * @param parameterErrors relative errors of the parameters of the hidden causes that it named
 * @param expectedErrors what the deviations that it states say of them: half of all errors are
 *     smaller
 * @param covered of their numbers so many are within the 95 % intervals
 * @param stated of their numbers so many have one
 * @param errorLeft of the model on held-out runs against the truth: 0 perfect, 1 no gain, infinite
 *     if a prediction gets lost; NaN if nothing was hidden
 * @param alias what was said of an alias
 * @param baseline causes that sparse regression selects
 * @param isBaselineRight whether that is exact
 * @param seconds that the diagnosis took
 * @param repeat command that repeats it
 */
public record Outcome(
        Method method,
        CaseKind kind,
        double noise,
        long seed,
        String body,
        List<String> hidden,
        Answer said,
        boolean first,
        boolean exact,
        List<Double> parameterErrors,
        List<Double> expectedErrors,
        int covered,
        int stated,
        double errorLeft,
        AliasTold alias,
        List<String> baseline,
        boolean isBaselineRight,
        double seconds,
        String repeat) {
    /** The lists cannot be changed. */
    public Outcome {
        hidden = List.copyOf(hidden);
        parameterErrors = List.copyOf(parameterErrors);
        expectedErrors = List.copyOf(expectedErrors);
        baseline = List.copyOf(baseline);
    }

    /**
     * Whether the diagnosis does what is wanted of it. Of two causes that the data can tell apart
     * that is to name the right one; of two that it cannot, to name either, and to say so.
     */
    public boolean isRight() {
        return switch (kind) {
            case NULL -> said.verdict() == Verdict.NONE;
            case UNCOVERED -> said.verdict() == Verdict.UNEXPLAINED;
            case PAIR -> exact;
            case ALIAS -> alias.so() ? alias.told() : first && !alias.told();
            case SINGLE, WEAK -> first;
        };
    }
}
