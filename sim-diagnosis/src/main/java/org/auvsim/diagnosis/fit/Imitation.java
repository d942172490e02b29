package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.List;
import java.util.Optional;
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
     * What it gains of the position on held-out runs, each from a start of its own: as that of
     * causes is measured; the others tell the noise. Empty if no position was measured there.
     */
    public Optional<Gain> positionGain(BelievedModel model, Diagnosis diagnosis) {
        Noise noise = Noise.of(runs(diagnosis, false));
        Trial trial = new Trial(Stepping.exact(model), runs(diagnosis, true), noise);
        Hypothesis imitated = Hypothesis.NONE.and(this, new double[0]);
        Judged before = trial.prediction(Hypothesis.NONE);
        Foretold foretold = Foretold.of(before, trial.prediction(imitated), noise);
        return Optional.ofNullable(foretold.gains().get(Channel.POSITION));
    }

    private static List<MeasuredRun> runs(Diagnosis diagnosis, boolean heldOut) {
        return diagnosis.runs().stream()
                .filter(run -> run.isHeldOut() == heldOut)
                .map(DiagnosedRun::run)
                .toList();
    }
}
