package org.auvsim.diagnosis.cause;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.List;

/**
 * Causes of one kind. A user's own are found by {@link java.util.ServiceLoader}: name the class in
 * {@code META-INF/services/org.auvsim.diagnosis.cause.CauseFamily}.
 */
public interface CauseFamily {
    /**
     * Those that make sense for a model's body and what was measured of it; none if none does.
     *
     * @param runs that are to be explained, one or more
     */
    List<Cause> of(BelievedModel model, List<MeasuredRun> runs);
}
