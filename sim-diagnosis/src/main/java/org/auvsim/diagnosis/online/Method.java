package org.auvsim.diagnosis.online;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.List;
import java.util.function.BooleanSupplier;

/** How a learner finds out what its model lacks. */
interface Method {
    /**
     * What runs say of a model.
     *
     * @param fit to search with
     * @param heldOut to judge by
     * @param goesOn whether anybody still wants to know
     */
    Diagnosis diagnose(
            BelievedModel model,
            List<MeasuredRun> fit,
            List<MeasuredRun> heldOut,
            BooleanSupplier goesOn);
}
