package org.auvsim.examples.cause;

import org.auvsim.core.effect.IsotropicDrag;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.CauseFamily;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.List;

/** Mussels have settled on the hull: each kilogram of them adds drag, too. */
public final class Fouling implements CauseFamily {
    /** What a kilogram of mussels adds to the quadratic drag (kg/m). */
    private static final double DRAG = 0.4;

    @Override
    public List<Cause> of(BelievedModel model, List<MeasuredRun> runs) {
        return List.of(new Mussels());
    }

    private record Mussels() implements Cause {
        @Override
        public String id() {
            return "fouling";
        }

        @Override
        public List<Parameter> parameters() {
            return List.of(Parameter.positive("mussels", "kg", 0.1));
        }

        @Override
        public Variant in(Variant model, double[] theta) {
            double clean = model.body().mass().orElseThrow();
            return model.with(
                    body ->
                            body.mass(clean + theta[0])
                                    .effect(new IsotropicDrag(0, DRAG * theta[0], 0)));
        }
    }
}
