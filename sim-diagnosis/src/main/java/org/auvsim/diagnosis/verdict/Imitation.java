package org.auvsim.diagnosis.verdict;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.model.Variant;

import java.util.List;
import java.util.function.UnaryOperator;

/**
 * What imitates a misfit and is no cause that is searched for.
 *
 * @param change of the model
 */
record Imitation(UnaryOperator<Variant> change) implements Cause {
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
}
