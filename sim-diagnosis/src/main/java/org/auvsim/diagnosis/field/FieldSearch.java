package org.auvsim.diagnosis.field;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.ForceResidual;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.result.Proposal;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.verdict.ImitationTrial;
import org.auvsim.diagnosis.verdict.Imitator;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

/**
 * Maps the force that a model lacks by place, where no known cause explains it: as the slope of
 * potentials along the paths. The map is a patch; it says nothing of where no run has been. It may
 * leave more than noise, as it changes no verdict: it has to halve the held-out error.
 */
public final class FieldSearch implements Imitator {
    /** Widths that are tried, as shares of the paths' range. */
    private static final int WIDTHS = 10;

    private static final double NARROWEST = 0.05;
    private static final double WIDEST = 0.4;

    /** In widths: between centres, and from the paths to them; one on a path cannot push aside. */
    private static final double SPACING = 1.1;

    private static final double REACH = 1.2;
    private static final int MOST = 110;

    /** Fewer forces than this tell nothing. */
    private static final int FEWEST = 8;

    /** What evidence must gain over that of noise. */
    private static final double LEAST_GAIN = 6;

    /** The error on held-out runs must fall to this share: by chance it does not. */
    private static final double MOST_LEFT = 0.5;

    /** Where a force was missing. */
    private record Sample(Vec3 place, Vec3 force) {}

    /** A field, and how much it has for itself. */
    private record Found(PotentialField field, double evidence) {}

    /** A field that halves the error on held-out runs at least. */
    @Override
    public Optional<Proposal> proposal(Diagnosis diagnosis, ImitationTrial trial) {
        List<DiagnosedRun> fit = diagnosis.runs().stream().filter(r -> !r.isHeldOut()).toList();
        return field(fit, trial::goesOn)
                .flatMap(
                        field ->
                                gain(field, trial)
                                        .filter(g -> g.after() < MOST_LEFT * g.before())
                                        .map(g -> proposal(field, samples(fit), g)));
    }

    /**
     * The field along runs; empty if they say too little, or noise imitates it as well; of the
     * narrow ones that were tried once it is stopped.
     */
    static Optional<PotentialField> field(List<DiagnosedRun> runs, BooleanSupplier goesOn) {
        List<Sample> samples = samples(runs);
        return samples.size() < FEWEST
                ? Optional.empty()
                : found(samples, places(runs.stream().map(DiagnosedRun::run).toList()), goesOn);
    }

    private static List<Sample> samples(List<DiagnosedRun> runs) {
        return runs.stream().flatMap(run -> samples(run).stream()).toList();
    }

    private static Proposal proposal(PotentialField field, List<Sample> samples, Gain gain) {
        double largest =
                samples.stream().mapToDouble(s -> field.at(s.place()).norm()).max().orElse(0);
        String text =
                String.format(
                        Locale.ROOT,
                        "%d potentials of a width of %.3g m along the paths; the force is %.3g N at"
                                + " most",
                        field.centres().size(),
                        field.width(),
                        largest);
        return new Proposal("force_field", text, gain);
    }

    private static List<Sample> samples(DiagnosedRun of) {
        MeasuredRun run = of.run();
        List<Sample> samples = new ArrayList<>();
        for (ForceResidual residual : of.forces()) {
            Vec3 force = residual.before();
            if (Double.isFinite(force.x() + force.y() + force.z())) {
                run.vector(Channel.POSITION, run.sampleAt(residual.time()))
                        .ifPresent(place -> samples.add(new Sample(place, force)));
            }
        }
        return samples;
    }

    private static List<Vec3> places(List<MeasuredRun> runs) {
        return runs.stream()
                .flatMap(
                        run ->
                                IntStream.range(0, run.size())
                                        .mapToObj(k -> run.vector(Channel.POSITION, k))
                                        .flatMap(Optional::stream))
                .toList();
    }

    /** The field that imitates the forces best; empty if noise does as well. */
    private static Optional<PotentialField> found(
            List<Sample> samples, List<Vec3> places, BooleanSupplier goesOn) {
        RealVector forces = forces(samples);
        double range = range(places);
        if (!(range > 0)) {
            return Optional.empty(); // a body that stays where it is shows nothing of other places
        }
        return IntStream.range(0, WIDTHS)
                .takeWhile(_ -> goesOn.getAsBoolean())
                .mapToDouble(
                        i -> NARROWEST * StrictMath.pow(WIDEST / NARROWEST, i / (WIDTHS - 1.0)))
                .mapToObj(share -> field(samples, forces, places, share * range))
                .flatMap(Optional::stream)
                .max(Comparator.comparingDouble(Found::evidence))
                .filter(
                        found ->
                                found.evidence()
                                        > Regression.evidenceOfNothing(forces) + LEAST_GAIN)
                .map(Found::field);
    }

    /** The largest extent along an axis of the world. */
    private static double range(List<Vec3> places) {
        double[] low = new double[3];
        double[] high = new double[3];
        Arrays.fill(low, Double.POSITIVE_INFINITY);
        Arrays.fill(high, Double.NEGATIVE_INFINITY);
        for (Vec3 place : places) {
            double[] numbers = {place.x(), place.y(), place.z()};
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = Math.min(low[axis], numbers[axis]);
                high[axis] = Math.max(high[axis], numbers[axis]);
            }
        }
        return Math.max(high[0] - low[0], Math.max(high[1] - low[1], high[2] - low[2]));
    }

    private static RealVector forces(List<Sample> samples) {
        RealVector forces = new ArrayRealVector(3 * samples.size());
        for (int s = 0; s < samples.size(); s++) {
            set(forces, s, samples.get(s).force());
        }
        return forces;
    }

    private static void set(RealVector of, int sample, Vec3 value) {
        of.setEntry(3 * sample, value.x());
        of.setEntry(3 * sample + 1, value.y());
        of.setEntry(3 * sample + 2, value.z());
    }

    /** Empty if that many narrow potentials would be too many. */
    private static Optional<Found> field(
            List<Sample> samples, RealVector forces, List<Vec3> places, double width) {
        List<Vec3> centres = new Grid(SPACING * width).within(REACH * width, places);
        if (centres.size() > MOST) {
            return Optional.empty();
        }
        RealMatrix columns = new Array2DRowRealMatrix(3 * samples.size(), centres.size());
        for (int c = 0; c < centres.size(); c++) {
            PotentialField one = new PotentialField(List.of(centres.get(c)), List.of(1.0), width);
            RealVector column = new ArrayRealVector(3 * samples.size());
            for (int s = 0; s < samples.size(); s++) {
                set(column, s, one.at(samples.get(s).place()));
            }
            columns.setColumnVector(c, column);
        }
        Regression regression = Regression.of(columns, forces);
        List<Double> heights = Arrays.stream(regression.weights().toArray()).boxed().toList();
        return Optional.of(
                new Found(new PotentialField(centres, heights, width), regression.evidence()));
    }

    /** On held-out runs, of the position. */
    private static Optional<Gain> gain(PotentialField field, ImitationTrial trial) {
        return trial.positionGain(variant -> variant.with(body -> body.effect(field)));
    }
}
