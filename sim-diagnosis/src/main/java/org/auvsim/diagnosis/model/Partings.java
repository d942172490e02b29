package org.auvsim.diagnosis.model;

import static org.auvsim.diagnosis.model.Ensemble.Commands.FROM_ROW_TO_ROW;

import org.auvsim.core.math.Vec3;
import org.auvsim.core.step.StepException;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/** What changes of a model do to a motion, before they have changed that motion. */
public final class Partings {
    /**
     * Duration of a short leg (s): what causes do hardly changes within it, and a swing is its
     * mean, its change and its bend.
     */
    public static final double SHORT = 0.2;

    /** So many variants at a time, so that there is work for all processors. */
    private static final int MOST = 128;

    /** Steps may be longer than the model's by this factor. */
    private static final double LONGER = 4;

    private Partings() {}

    /**
     * A part of a run that all variants begin alike.
     *
     * @param from its first sample
     * @param to its last, the first of the next leg
     * @param start the motion at its first sample
     * @param end the motion at its last
     */
    public record Leg(int from, int to, RigidMotion start, RigidMotion end) {
        /** The place (m) half-way in time, of so many seconds: on the cubic with both ends. */
        Vec3 middle(double duration) {
            Vec3 bend = start.velocity().minus(end.velocity()).times(duration / 8);
            return start.position().plus(end.position()).times(0.5).plus(bend);
        }
    }

    /**
     * By how much variants part from another one in legs that follow one another, each begun alike.
     * Steps may be longer here than the model's: only the difference of two motions counts.
     *
     * @return by variant and leg the error of its motion at the leg's end ({@link
     *     RigidMotion#minus}); of NaN if it gets out of all bounds
     */
    public static double[][][] of(
            BelievedModel model,
            MeasuredRun run,
            List<Leg> legs,
            Variant from,
            List<Variant> variants) {
        Swings swings = new Swings(run, legs, from, variants);
        return swings.all(simulated(model, run, legs, from, swings.toSimulate()));
    }

    private static double[][][] simulated(
            BelievedModel model,
            MeasuredRun run,
            List<Leg> legs,
            Variant from,
            List<Variant> variants) {
        int most = Math.min(MOST, Ensemble.together(model, entrants(legs, variants)));
        int batches = (variants.size() + most - 1) / most;
        return IntStream.range(0, batches)
                .parallel()
                .mapToObj(b -> batch(variants, b, batches))
                .map(batch -> someParting(model, run, legs, from, batch))
                .flatMap(Arrays::stream)
                .toArray(double[][][]::new);
    }

    private static List<Variant> batch(List<Variant> variants, int batch, int of) {
        int size = variants.size();
        return variants.subList(batch * size / of, (batch + 1) * size / of);
    }

    private static List<Entrant> entrants(List<Leg> legs, List<Variant> variants) {
        return variants.stream().map(v -> new Entrant(v, legs.getFirst().start())).toList();
    }

    private static double[][][] someParting(
            BelievedModel model,
            MeasuredRun run,
            List<Leg> legs,
            Variant from,
            List<Variant> variants) {
        List<Variant> all = new ArrayList<>();
        all.add(from);
        all.addAll(variants);
        double step = LONGER * model.scenario().timeStep().delta();
        try {
            int first = legs.getFirst().from();
            return new Ensemble(model, run, first, entrants(legs, all), step, FROM_ROW_TO_ROW)
                    .part(legs);
        } catch (StepException e) {
            if (variants.size() == 1) {
                return new double[][][] {unknown(legs.size())};
            }
            double[][][] first = someParting(model, run, legs, from, batch(variants, 0, 2));
            double[][][] second = someParting(model, run, legs, from, batch(variants, 1, 2));
            double[][][] both = Arrays.copyOf(first, variants.size());
            System.arraycopy(second, 0, both, first.length, second.length);
            return both;
        }
    }

    private static double[][] unknown(int legs) {
        double[][] unknown = new double[legs][RigidMotion.SIZE];
        for (double[] ofLeg : unknown) {
            Arrays.fill(ofLeg, Double.NaN);
        }
        return unknown;
    }
}
