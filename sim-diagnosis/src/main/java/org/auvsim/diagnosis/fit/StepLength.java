package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.model.BelievedModel;
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

    /** The engine may cut so many of them a sample: then shorter ones would cost less. */
    private static final double FEW_CUTS = 0.1;

    private static final int MOST_HALVINGS = 4;

    private StepLength() {}

    /** The model with steps that are short enough, judged over windows that follow the runs. */
    static Stepping converged(Fit following) {
        BelievedModel now = following.model();
        for (int h = 0; h < MOST_HALVINGS; h++) {
            Stepping finer = Stepping.finer(now, step(now, following));
            if (difference(finer, following) < SHARE) {
                break;
            }
            now = finer.rough();
        }
        return Stepping.longer(now).stream()
                .filter(longer -> difference(longer, following) < ROUGH)
                .filter(longer -> cuts(longer, following) < FEW_CUTS)
                .findFirst()
                .orElse(Stepping.exact(now));
    }

    /** The most of any run. */
    private static double cuts(Stepping stepping, Fit following) {
        double most = 0;
        for (int r = 0; r < following.data().size(); r++) {
            Shooting shooting =
                    new Shooting(stepping, following.variant(), following.data().get(r));
            for (Window window : following.windows().get(r)) {
                most = Math.max(most, shooting.cuts(window));
            }
        }
        return most;
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

    /** The largest of any number; infinite where a motion gets out of all bounds. */
    private static double difference(Stepping stepping, Fit following) {
        return IntStream.range(0, following.data().size())
                .parallel()
                .mapToDouble(
                        r ->
                                difference(
                                        new Shooting(
                                                stepping,
                                                following.variant(),
                                                following.data().get(r)),
                                        following.windows().get(r)))
                .max()
                .orElse(0);
    }

    private static double difference(Shooting shooting, List<Window> windows) {
        double largest = 0;
        for (Window window : windows) {
            RigidMotion[] motion = shooting.motion(window);
            double[] one = shooting.misses(window, motion);
            double[] other = shooting.misses(window, shooting.rough(window, motion));
            for (int i = 0; i < one.length; i++) {
                double difference = Math.abs(one[i] - other[i]);
                largest =
                        Double.isNaN(difference)
                                ? Double.POSITIVE_INFINITY
                                : Math.max(largest, difference);
            }
        }
        return largest;
    }
}
