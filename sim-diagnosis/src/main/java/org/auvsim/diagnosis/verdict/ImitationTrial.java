package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Stepping;

import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;

/** Held-out runs judge imitations of a misfit as they did causes, in steps of the same length. */
public final class ImitationTrial {
    private final Trial trial;
    private final Noise noise;
    private final Course course;

    ImitationTrial(Stepping stepping, List<MeasuredRun> heldOut, Noise noise, Course course) {
        this.trial = new Trial(stepping, heldOut, noise);
        this.noise = noise;
        this.course = course;
    }

    /** Whether anybody still wants to know. */
    public boolean goesOn() {
        return course.goesOn();
    }

    /**
     * What a change of the model gains of the position, each run from a start of its own. Empty if
     * no position was measured there, or once it was told to stop.
     */
    public Optional<Gain> positionGain(UnaryOperator<Variant> change) {
        Hypothesis imitated = Hypothesis.NONE.and(new Imitation(change), new double[0]);
        Judged before = trial.prediction(Hypothesis.NONE, course);
        Judged after = trial.prediction(imitated, course);
        return course.goesOn()
                ? Optional.ofNullable(
                        Foretold.of(before, after, noise).gains().get(Channel.POSITION))
                : Optional.empty();
    }
}
