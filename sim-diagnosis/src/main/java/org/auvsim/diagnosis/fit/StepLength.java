package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.model.Sensing;
import org.auvsim.server.feedback.RigidMotion;

import java.util.List;

/**
 * Shortens the model's steps until half of them makes no difference that the data could show: else
 * the integrator's error would be taken for a cause.
 */
final class StepLength {
    /** Half the step may move a prediction by this share of the noise. */
    private static final double SHARE = 0.1;

    private static final int MOST_HALVINGS = 4;

    private StepLength() {}

    /** The model with steps that are short enough, judged over windows that follow the runs. */
    static BelievedModel converged(BelievedModel model, Fit following) {
        BelievedModel now = model;
        for (int h = 0; h < MOST_HALVINGS; h++) {
            BelievedModel finer = now.stepping(step(now, following) / 2);
            if (difference(now, finer, following) < SHARE) {
                break;
            }
            now = finer;
        }
        return now;
    }

    /** The longest step that is really made: none is longer than the time between samples. */
    private static double step(BelievedModel model, Fit following) {
        double longest = 0;
        for (Misses of : following.data()) {
            for (int k = 1; k < of.run().size(); k++) {
                longest = Math.max(longest, of.run().time(k) - of.run().time(k - 1));
            }
        }
        return Math.min(longest, model.scenario().timeStep().delta());
    }

    private static double difference(BelievedModel one, BelievedModel other, Fit following) {
        double largest = 0;
        for (int r = 0; r < following.data().size(); r++) {
            Misses of = following.data().get(r);
            for (Window window : following.windows().get(r)) {
                double[] a = misses(one, of, window);
                double[] b = misses(other, of, window);
                for (int i = 0; i < a.length; i++) {
                    largest = Math.max(largest, Math.abs(a[i] - b[i]));
                }
            }
        }
        return largest;
    }

    private static double[] misses(BelievedModel model, Misses of, Window window) {
        RigidMotion[] motion =
                Ensemble.simulate(
                        model,
                        of.run(),
                        window.from(),
                        window.to(),
                        List.of(new Entrant(model.variant(), window.start())))[0];
        return of.of(motion, Sensing.EXACT, window.from(), window.length() + 1);
    }
}
