package org.auvsim.diagnosis.result;

import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import java.util.List;

/**
 * A run beside what the model makes of it, sample by sample, as its sensors would tell.
 *
 * @param isHeldOut whether nothing was fitted to it but its start
 * @param before as the model was believed, from the start of {@code after}
 * @param after with what was found, from the start that suits it best
 * @param forces that are missing along it, in the order of time
 */
public record DiagnosedRun(
        MeasuredRun run,
        boolean isHeldOut,
        List<RigidMotion> before,
        List<RigidMotion> after,
        List<ForceResidual> forces) {
    /** The lists cannot be changed. */
    public DiagnosedRun {
        before = List.copyOf(before);
        after = List.copyOf(after);
        forces = List.copyOf(forces);
    }
}
