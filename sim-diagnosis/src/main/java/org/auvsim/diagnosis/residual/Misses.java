package org.auvsim.diagnosis.residual;

import org.auvsim.auvsml.run.LastingError;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.Sensing;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.OrientationError;
import org.auvsim.diagnosis.run.Reading;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * By how much simulated motions miss a measured run, in standard deviations: a row for each axis of
 * each channel that was measured at all, 0 in samples that have no number there.
 */
public final class Misses {
    private final MeasuredRun run;
    private final List<Row> rows = new ArrayList<>();

    /** About how many axes turns tell: of fewer than all, whole rotation vectors mean nothing. */
    private final long turns;

    /** By row: for errors that last; empty where they are noise. */
    private final List<Optional<Whitening>> whitenings = new ArrayList<>();

    /** By sample and row: one over the standard deviation; 0 where nothing was measured. */
    private final double[] weights;

    /** By sample and row: the standard deviation, in the channel's unit. */
    private final double[] deviations;

    /** By sample and row: whether it is a number that tells nothing of how right a motion is. */
    private final boolean[] outliers;

    /** By sample and row: whether it counts as noise whatever the motion, see {@link #seen}. */
    private final boolean[] unseen;

    private final double independent;

    /** An axis (0 to 2) of a channel. */
    public record Row(Channel channel, int axis) {}

    /** Those of runs with this noise, outliers tamed. */
    public static List<Misses> of(List<MeasuredRun> runs, Noise noise) {
        return runs.stream().map(run -> HeavyTails.tamed(new Misses(run, noise), noise)).toList();
    }

    /** Those of a run whose measurements have this noise, where they do not state their own. */
    public Misses(MeasuredRun run, Noise noise) {
        this.run = run;
        for (Channel channel : Channel.values()) {
            for (int axis = 0; axis < 3; axis++) {
                if (run.measures(channel, axis) && noise.tells(channel, axis)) {
                    rows.add(new Row(channel, axis));
                    List<LastingError> errors = new ArrayList<>(run.lastingErrors(channel, axis));
                    noise.lasting(channel, axis).ifPresent(errors::add);
                    whitenings.add(Whitening.of(errors));
                }
            }
        }
        turns = rows.stream().filter(row -> row.channel() == Channel.ORIENTATION).count();
        weights = new double[run.size() * rows.size()];
        deviations = new double[weights.length];
        outliers = new boolean[weights.length];
        unseen = new boolean[weights.length];
        for (int k = 0; k < run.size(); k++) {
            for (int r = 0; r < rows.size(); r++) {
                Row row = rows.get(r);
                int i = k * rows.size() + r;
                double stated = run.deviation(row.channel(), k, row.axis());
                deviations[i] =
                        Double.isNaN(stated) ? noise.anew(row.channel(), row.axis()) : stated;
                boolean isMeasured = !Double.isNaN(run.value(row.channel(), k, row.axis()));
                weights[i] = isMeasured ? 1 / deviations[i] : 0;
            }
        }
        independent = countIndependent();
    }

    private Misses(Misses of, double[] weights, boolean[] outliers, boolean[] unseen) {
        this.run = of.run;
        this.deviations = of.deviations;
        this.rows.addAll(of.rows);
        this.turns = of.turns;
        this.whitenings.addAll(of.whitenings);
        this.weights = weights;
        this.outliers = outliers;
        this.unseen = unseen;
        this.independent = countIndependent();
    }

    /** The same, each number weighed by a factor beside; numbers as {@link #isMeasured}. */
    Misses weighed(double[] factors, boolean[] areOutliers) {
        double[] product = weights.clone();
        for (int i = 0; i < product.length; i++) {
            product[i] *= factors[i];
        }
        return new Misses(this, product, areOutliers, unseen);
    }

    /**
     * The same to sensors that are late or ahead: where they tell of times beyond the run and that
     * is missed by more than noise, it counts as noise from now on, whatever the motion.
     *
     * @param misses of all samples, row by row, in standard deviations, as if all were seen
     */
    public Misses seen(Sensing sensing, double[] misses) {
        return withUnseen(Unseen.of(this, sensing, misses));
    }

    /** The same, every number told as the motion has it. */
    public Misses allSeen() {
        return withUnseen(new boolean[unseen.length]);
    }

    private Misses withUnseen(boolean[] other) {
        return Arrays.equals(unseen, other) ? this : new Misses(this, weights, outliers, other);
    }

    /** Whether what is missed of a sample tells of what is missed of those after it. */
    public boolean hasLastingErrors() {
        return whitenings.stream().anyMatch(Optional::isPresent);
    }

    /** The run that is missed. */
    public MeasuredRun run() {
        return run;
    }

    /**
     * Whether the run tells anything of each number of a start at a sample, directly or by where it
     * led: a path in two dimensions also shows how a body is turned, if nothing tells of that. What
     * it does not show is as the model has it, as are angles that are not measured where others
     * are: a fit would misuse them to imitate something else.
     */
    public boolean[] shown(int sample) {
        boolean[] turns = turns(sample);
        boolean[] shown = new boolean[RigidMotion.SIZE];
        boolean showsTurns =
                tells(Channel.ANGULAR_VELOCITY)
                        || (!tells(Channel.ORIENTATION) && count(Channel.POSITION) > 1);
        for (int axis = 0; axis < 3; axis++) {
            boolean isPlaced =
                    rows.contains(new Row(Channel.POSITION, axis)) || tells(Channel.VELOCITY);
            boolean isTurned = turns[axis] || showsTurns;
            shown[axis] = isPlaced;
            shown[3 + axis] = isTurned;
            shown[6 + axis] = isPlaced;
            shown[9 + axis] = isTurned;
        }
        return shown;
    }

    /**
     * About which of the world's axes turns are told: where they are told about the body's, about
     * those that are nearest to these.
     */
    public boolean[] turns(int sample) {
        boolean[] turns = new boolean[3];
        for (int axis = 0; axis < 3; axis++) {
            if (rows.contains(new Row(Channel.ORIENTATION, axis))) {
                turns[inWorld(axis, sample)] = true;
            }
        }
        return turns;
    }

    private int inWorld(int axis, int sample) {
        if (run.frame(Channel.ORIENTATION) == Frame.WORLD) {
            return axis;
        }
        Vec3 unit = new Vec3(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
        Vec3 along = orientation(sample).rotate(unit);
        int nearest = 0;
        for (int i = 1; i < 3; i++) {
            boolean isNearer = Math.abs(along.component(i)) > Math.abs(along.component(nearest));
            nearest = isNearer ? i : nearest;
        }
        return nearest;
    }

    /** The first that is measured from a sample on, or else the last before it. */
    private Quat orientation(int sample) {
        return IntStream.concat(
                        IntStream.range(sample, run.size()),
                        IntStream.range(0, sample).map(k -> sample - 1 - k))
                .mapToObj(run::orientation)
                .flatMap(Optional::stream)
                .findFirst()
                .orElse(Quat.IDENTITY);
    }

    private boolean tells(Channel channel) {
        return count(channel) > 0;
    }

    /** Along or about how many axes a channel tells anything. */
    public long count(Channel channel) {
        return rows.stream().filter(row -> row.channel() == channel).count();
    }

    /** What is measured at each sample. */
    public List<Row> rows() {
        return rows;
    }

    /** The standard deviation of a number, in its channel's unit. */
    public double deviation(int index) {
        return deviations[index];
    }

    /** How many numbers there are. */
    public int count() {
        return (int) Arrays.stream(weights).filter(weight -> weight > 0).count();
    }

    /**
     * How many numbers there are, those of rows whose errors last counted as independent ones that
     * tell as much.
     */
    public double independent() {
        return independent;
    }

    private double countIndependent() {
        double sum = 0;
        for (int r = 0; r < rows.size(); r++) {
            Optional<Whitening> whitening = whitenings.get(r);
            sum +=
                    whitening.isPresent()
                            ? whitening.get().independent(weights, run, r, rows.size())
                            : count(r);
        }
        return sum;
    }

    private int count(int row) {
        int count = 0;
        for (int i = row; i < weights.length; i += rows.size()) {
            count += weights[i] > 0 ? 1 : 0;
        }
        return count;
    }

    /** Whether there is a number, counted row by row within each sample. */
    public boolean isMeasured(int index) {
        return weights[index] > 0;
    }

    /** Whether there is a number that errors are told of. */
    public boolean counts(int index) {
        return isMeasured(index) && !outliers[index] && !unseen[index];
    }

    /** A miss as {@link #plain} has it in the channel's unit, however little it weighs. */
    public double error(int index, double miss) {
        return miss / weights[index];
    }

    /**
     * Numbers of the run of which no errors are told: outliers, those of times beyond it, and all
     * that counts as not measured.
     */
    public Set<Reading> uncounted() {
        Set<Reading> uncounted = new HashSet<>();
        for (Channel channel : Channel.values()) {
            for (int axis = 0; axis < 3; axis++) {
                int row = rows.indexOf(new Row(channel, axis));
                for (int k = 0; k < run.size(); k++) {
                    boolean isMeasured = !Double.isNaN(run.value(channel, k, axis));
                    int index = k * rows.size() + row;
                    if (isMeasured && (row < 0 || outliers[index] || unseen[index])) {
                        uncounted.add(new Reading(channel, k, axis));
                    }
                }
            }
        }
        return uncounted;
    }

    /**
     * Whether the run states how much its errors last: then it says how much is to be explained.
     */
    boolean isStated(Row row) {
        return whitenings.get(rows.indexOf(row)).isPresent();
    }

    /**
     * Those of motions at samples from {@code from} on, row by row within each sample; where errors
     * last, less what those before tell of them.
     *
     * @param samples how many of the motions count
     */
    public double[] of(RigidMotion[] motions, Sensing sensing, int from, int samples) {
        double[] misses = plain(motions, sensing, from, samples);
        for (int r = 0; r < rows.size(); r++) {
            if (whitenings.get(r).isPresent()) {
                whitenings.get(r).get().apply(misses, weights, run, from, r, rows.size());
            }
        }
        neutralise(misses, from);
        return misses;
    }

    /** The same in standard deviations of the noise alone, whatever lasts. */
    public double[] plain(RigidMotion[] motions, Sensing sensing, int from, int samples) {
        double[] misses = new double[samples * rows.size()];
        RigidMotion[] told = sensing.of(motions, run, from, samples);
        for (int k = 0; k < samples; k++) {
            write(from + k, told[k], misses, k * rows.size());
        }
        neutralise(misses, from);
        return misses;
    }

    /** What is not seen is missed by a standard deviation, now to one side, now to the other. */
    private void neutralise(double[] misses, int from) {
        for (int i = 0; i < misses.length; i++) {
            if (unseen[from * rows.size() + i] && !Double.isNaN(misses[i])) {
                misses[i] = (from + i / rows.size()) % 2 == 0 ? 1 : -1;
            }
        }
    }

    /**
     * The same, so many samples taken together: the sum of those that were measured over the root
     * of their number, which is again in standard deviations.
     */
    public double[] of(RigidMotion[] motions, Sensing sensing, int from, int samples, int group) {
        double[] single = of(motions, sensing, from, samples);
        if (group == 1) {
            return single;
        }
        int width = rows.size();
        double[] together = new double[(samples + group - 1) / group * width];
        for (int first = 0; first < samples; first += group) {
            int count = Math.min(group, samples - first);
            double[] weights = together(from + first, count);
            int to = first / group * width;
            for (int k = first; k < first + count; k++) {
                for (int r = 0; r < width; r++) {
                    together[to + r] += weights[r] * single[k * width + r];
                }
            }
        }
        return together;
    }

    /** By row: how much each of so many samples counts that are taken together. */
    public double[] together(int from, int samples) {
        int width = rows.size();
        double[] counts = new double[width];
        for (int i = from * width; i < (from + samples) * width; i++) {
            counts[i % width] += weights[i] > 0 ? 1 : 0;
        }
        return Arrays.stream(counts).map(n -> n > 0 ? 1 / Math.sqrt(n) : 0).toArray();
    }

    private void write(int sample, RigidMotion told, double[] to, int at) {
        Channel of = Channel.POSITION;
        Vec3 off = told.position();
        boolean isFresh = false;
        for (int r = 0; r < rows.size(); r++) {
            Row row = rows.get(r);
            double weight = weights[sample * rows.size() + r];
            if (weight == 0) {
                continue;
            }
            if (!isFresh || row.channel() != of) {
                of = row.channel();
                off = told(of, sample, told);
                isFresh = true;
            }
            to[at + r] = weight * (off.component(row.axis()) - run.value(of, sample, row.axis()));
        }
    }

    private Vec3 told(Channel channel, int sample, RigidMotion told) {
        return switch (channel) {
            case POSITION -> told.position();
            case ORIENTATION ->
                    turns < 3
                            ? OrientationError.ofAngles(told.orientation(), run, sample)
                            : OrientationError.of(told.orientation(), run, sample);
            case VELOCITY -> inFrame(told.velocity(), told.orientation(), channel);
            case ANGULAR_VELOCITY -> inFrame(told.angularVelocity(), told.orientation(), channel);
        };
    }

    private Vec3 inFrame(Vec3 world, Quat orientation, Channel channel) {
        return run.frame(channel) == Frame.BODY ? orientation.rotateInverse(world) : world;
    }
}
