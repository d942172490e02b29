package org.auvsim.diagnosis.shooting;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Partings.Leg;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.server.feedback.RigidMotion;

/**
 * What errors of a motion do in a short leg of it, to first order: an error at its beginning, and
 * one that comes about within it.
 */
public final class LegResponse {
    private static final int SIZE = RigidMotion.SIZE;

    /** By number of the error at the beginning: the error at the end. */
    private final double[][] transition = new double[SIZE][];

    /** By number of the error at the beginning: what it adds to the misses of the leg's samples. */
    private final double[][] shown = new double[SIZE][];

    /** By number of the error at the end that comes about within: the same. */
    private final double[][] shownOfParting = new double[SIZE][];

    /**
     * Of a leg.
     *
     * @param samples how many of the leg's count
     * @param weights by row: how much each counts where samples are taken together
     */
    public LegResponse(Shooting shooting, Leg leg, int samples, double[] weights) {
        BelievedModel model = shooting.stepping().model();
        Variant variant = shooting.variant();
        Misses of = shooting.of();
        RigidMotion[][] motions =
                Ensemble.simulate(
                        shooting.stepping().rough(),
                        of.run(),
                        leg.from(),
                        leg.to(),
                        shooting.fromAllStarts(leg.from(), leg.start()));
        double[] before = sum(of.of(motions[0], variant.sensing(), leg.from(), samples), weights);
        RigidMotion end = motions[0][leg.to() - leg.from()];
        for (int i = 0; i < SIZE; i++) {
            double step = Shooting.step(i);
            RigidMotion[] moved = motions[i + 1];
            RigidMotion[] parting = parting(of, leg, motions[0], model, i, step);
            transition[i] = Shooting.slope(moved[leg.to() - leg.from()].minus(end), step);
            shown[i] = slope(of, moved, variant, leg, samples, weights, before, step);
            shownOfParting[i] = slope(of, parting, variant, leg, samples, weights, before, step);
        }
    }

    /** An error that begins with nothing: velocities grow evenly, so that the way is a parabola. */
    private static RigidMotion[] parting(
            Misses of, Leg leg, RigidMotion[] motion, BelievedModel model, int i, double step) {
        if (motion[0].equals(Ensemble.LOST)) {
            return motion; // nothing is known of what would become of it
        }
        double begin = of.run().time(leg.from());
        double duration = of.run().time(leg.to()) - begin;
        RigidMotion[] moved = new RigidMotion[motion.length];
        for (int k = 0; k < moved.length; k++) {
            double share = duration > 0 ? (of.run().time(leg.from() + k) - begin) / duration : 0;
            double[] by = new double[SIZE];
            by[i] = step * (i < SIZE / 2 ? share * share : share);
            moved[k] = motion[k].plus(model.free(by));
        }
        return moved;
    }

    private static double[] slope(
            Misses of,
            RigidMotion[] moved,
            Variant variant,
            Leg leg,
            int samples,
            double[] weights,
            double[] before,
            double step) {
        double[] misses = of.of(moved, variant.sensing(), leg.from(), samples);
        return Shooting.slope(sum(misses, weights), before, step);
    }

    private static double[] sum(double[] misses, double[] weights) {
        int width = weights.length;
        double[] sum = new double[width];
        for (int k = 0; k < misses.length; k++) {
            sum[k % width] += weights[k % width] * misses[k];
        }
        return sum;
    }

    /**
     * Adds what errors show in the leg to its rows of a column, and carries them to its end.
     *
     * @param error at the leg's beginning; that at its end afterwards
     * @param parting what comes about within the leg, at its end
     * @param rows of a column, those of the leg's samples from {@code at} on
     */
    public void carry(double[] error, double[] parting, double[] rows, int at) {
        double[] end = parting.clone();
        for (int i = 0; i < SIZE; i++) {
            double begun = error[i];
            double come = parting[i];
            if (begun == 0 && come == 0) {
                continue;
            }
            double[] of = shown[i];
            double[] ofParting = shownOfParting[i];
            for (int r = 0; r < of.length; r++) {
                rows[at + r] += begun * of[r] + come * ofParting[r];
            }
            double[] to = transition[i];
            for (int j = 0; j < SIZE; j++) {
                end[j] += begun * to[j];
            }
        }
        System.arraycopy(end, 0, error, 0, SIZE);
    }
}
