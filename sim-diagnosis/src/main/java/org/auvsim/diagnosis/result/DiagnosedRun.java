package org.auvsim.diagnosis.result;

import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.Reading;
import org.auvsim.server.feedback.RigidMotion;

import java.util.List;
import java.util.Set;

/**
 * A run beside what the model makes of it, sample by sample, as its sensors would tell.
 *
 * @param isHeldOut whether it was to judge: nothing was fitted to it but its start, unless the
 *     search had to use such runs, too
 * @param before as the model was believed, from the start of {@code after}
 * @param after with what was found, from the start that suits it best
 * @param forces that are missing along it, in the order of time
 * @param uncounted what was measured but tells nothing of how right a model is, so that no errors
 *     are told of it: outliers, and what counts as not measured
 */
public record DiagnosedRun(
        MeasuredRun run,
        boolean isHeldOut,
        List<RigidMotion> before,
        List<RigidMotion> after,
        List<ForceResidual> forces,
        Set<Reading> uncounted) {
    /** The lists and the set cannot be changed. */
    public DiagnosedRun {
        before = List.copyOf(before);
        after = List.copyOf(after);
        forces = List.copyOf(forces);
        uncounted = Set.copyOf(uncounted);
    }

    /** The run as if that had not been measured of which no errors are told. */
    public MeasuredRun counted() {
        return uncounted.isEmpty() ? run : run.without(uncounted);
    }
}
