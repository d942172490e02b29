package org.auvsim.diagnosis.subject;

import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Descent;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Refinement;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Stepping;

import java.util.List;

/** A model without any cause, fitted to runs by their starts alone. */
public final class AsBelieved {
    private static final int STEPS = 20;

    private AsBelieved() {}

    /** What follows the runs by it. */
    public static Fit followed(BelievedModel model, List<MeasuredRun> runs, Noise noise) {
        return Following.of(Stepping.exact(model), Hypothesis.NONE, Misses.of(runs, noise), noise);
    }

    /** The fit, brought to where it misses least. */
    public static Judged fitted(BelievedModel model, List<MeasuredRun> runs, Noise noise) {
        return Descent.of(Refinement.approach(followed(model, runs, noise), 1))
                .steps(STEPS, Double.POSITIVE_INFINITY, Course.UNHEARD);
    }
}
