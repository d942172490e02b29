package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;

/**
 * What imitates a misfit and is no cause that is searched for.
 *
 * @param change of the model
 */
public record Imitation(UnaryOperator<Variant> change) implements Cause {
    @Override
    public String id() {
        return "imitation";
    }

    @Override
    public List<Parameter> parameters() {
        return List.of();
    }

    @Override
    public Variant in(Variant model, double[] theta) {
        return change.apply(model);
    }

    /**
     * What it gains on held-out runs, each from a start of its own: as that of causes is measured.
     *
     * @param fit runs that tell the noise
     */
    public Map<Channel, Gain> gains(
            BelievedModel model, List<MeasuredRun> fit, List<MeasuredRun> heldOut) {
        Noise noise = Noise.of(fit);
        Trial trial = new Trial(Stepping.exact(model), heldOut, noise);
        Hypothesis imitated = Hypothesis.NONE.and(this, new double[0]);
        Judged before = trial.prediction(Hypothesis.NONE);
        return Foretold.of(before, trial.prediction(imitated), noise).gains();
    }
}
