package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.model.Sensing;
import org.auvsim.server.feedback.RigidMotion;

import java.util.List;
import java.util.stream.IntStream;

/**
 * Shortens the model's steps until half of them makes no difference that the data could show: else
 * the integrator's error would be taken for a cause.
 */
final class StepLength {
    /** Half the step may move a prediction by this share of the noise. */
    private static final double SHARE = 0.1;

    /** Steps that do for differences may move it by so much noise. */
    private static final double ROUGH = 1;

    private static final int MOST_HALVINGS = 4;

    private StepLength() {}

    /** The model with steps that are short enough, judged over windows that follow the runs. */
    static Stepping converged(Fit following) {
        BelievedModel now = following.model();
        for (int h = 0; h < MOST_HALVINGS; h++) {
            BelievedModel finer = now.stepping(step(now, following) / 2);
            if (difference(now, finer, following) < SHARE) {
                break;
            }
            now = finer;
        }
        Stepping longer = Stepping.hopeful(now);
        return difference(now, longer.rough(), following) < ROUGH ? longer : Stepping.exact(now);
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
        return IntStream.range(0, following.data().size())
                .parallel()
                .mapToDouble(
                        r ->
                                difference(
                                        one,
                                        other,
                                        following.data().get(r),
                                        following.windows().get(r)))
                .max()
                .orElse(0);
    }

    /** The largest of any number of a run; infinite where a motion gets out of all bounds. */
    private static double difference(
            BelievedModel one, BelievedModel other, Misses of, List<Window> windows) {
        double largest = 0;
        for (Window window : windows) {
            double[] a = misses(one, of, window);
            double[] b = misses(other, of, window);
            for (int i = 0; i < a.length; i++) {
                double difference = Math.abs(a[i] - b[i]);
                largest =
                        Double.isNaN(difference)
                                ? Double.POSITIVE_INFINITY
                                : Math.max(largest, difference);
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
