package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.fit.Descent;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;

import java.util.stream.IntStream;

/**
 * Whether causes undo one another: a run needs none of them, and bears none alone, but all together
 * leave it as it is, as a current down and positions that drift up do. What they are needed for in
 * other runs is then a whim of where they do not quite cancel, and no cause.
 */
final class Undoing {
    /** Enough for the starts. */
    private static final int STEPS = 12;

    /** Squares of what is missed (standard deviations) a number that no noise makes. */
    private static final double FAR_OFF = 4;

    private Undoing() {}

    /**
     * Whether it is so in one of the runs.
     *
     * @param none the model as it is believed
     */
    static boolean isIn(Judged none, Hypothesis causes) {
        return causes.causes().size() > 1
                && IntStream.range(0, none.fit().data().size())
                        .anyMatch(run -> isIn(none.fit().ofRun(run), causes));
    }

    private static boolean isIn(Fit run, Hypothesis causes) {
        return Judged.of(run).isWhite()
                && IntStream.range(0, causes.causes().size())
                        .allMatch(cause -> isContradicted(run, alone(causes, cause)));
    }

    private static Hypothesis alone(Hypothesis of, int cause) {
        return Hypothesis.NONE.and(of.causes().get(cause), of.theta().get(cause)).settled();
    }

    private static boolean isContradicted(Fit run, Hypothesis alone) {
        Judged fitted = Descent.of(run.with(alone, run.windows())).steps(STEPS);
        return fitted.cost() > FAR_OFF * fitted.outcome().count();
    }
}
