package org.auvsim.diagnosis.fit;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.result.ForceResidual;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.List;

/**
 * The force that a model lacks along a run: by how much the velocity at the beginning of a short
 * window differs from what the model makes of the window before, times mass over time.
 */
final class MissingForce {
    private MissingForce() {}

    /** Before and after, where the windows under the believed model begin. */
    static List<ForceResidual> along(BelievedModel model, Variant after, Misses run, Noise noise) {
        Variant before = model.variant();
        List<Window> windows = new Following(model, before, run, noise).shortWindows();
        List<ForceResidual> forces = new ArrayList<>();
        for (int w = 0; w + 1 < windows.size(); w++) {
            Window window = windows.get(w);
            Window next = windows.get(w + 1);
            forces.add(
                    new ForceResidual(
                            run.run().time(window.to()),
                            force(model, before, run, window, next),
                            force(model, after, run, window, next)));
        }
        return forces;
    }

    private static Vec3 force(
            BelievedModel model, Variant variant, Misses run, Window window, Window next) {
        RigidMotion[] motion =
                Ensemble.simulate(
                        model,
                        run.run(),
                        window.from(),
                        window.to(),
                        List.of(new Entrant(variant, window.start())))[0];
        double between = (run.run().time(next.to()) - run.run().time(window.from())) / 2;
        Vec3 jump = next.start().velocity().minus(motion[window.length()].velocity());
        return jump.times(variant.body().mass().orElse(1.0) / between);
    }
}
