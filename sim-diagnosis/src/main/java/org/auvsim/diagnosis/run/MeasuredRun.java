package org.auvsim.diagnosis.run;

import org.auvsim.auvsml.run.LastingError;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;

/**
 * A measured run: where a body was when, and what it was told to do. Times increase; a number that
 * was not measured is NaN. Immutable.
 */
public final class MeasuredRun {
    /** Fewer samples tell nothing, of a run or of a part of one. */
    public static final int FEWEST = 16;

    /** From here on (s) the digits before the point say nothing to people. */
    private static final double FAR = 1e6;

    private static final int AXES = 3;

    private final String name;
    private final double[] times;
    private final Map<Channel, double[]> measured;
    private final Map<Channel, double[]> deviations;
    private final double[] quaternions;

    /** Roll, pitch and yaw (rad) of each sample; NaN where no orientation was measured. */
    private final double[] angles;

    private final int[] turns;
    private final double[] accelerations;
    private final double[] rates;
    private final Map<Channel, Frame> frames;
    private final Map<Channel, Map<Integer, List<LastingError>>> lasting;
    private final List<Command> commands;
    private final List<ScheduledForce> forces;
    private final Optional<KnownStart> start;
    private final KnownDifferences differences;
    private final boolean beginsMidway;
    private final Optional<MeasuredRun> whole;
    private final Optional<MeasuredRun> uncut;

    MeasuredRun(MeasuredRunBuilder b) {
        name = b.name;
        times = b.times.toArray();
        measured = new EnumMap<>(Channel.class);
        deviations = new EnumMap<>(Channel.class);
        b.measured.forEach((channel, values) -> keep(measured, channel, values.toArray()));
        b.deviations.forEach((channel, values) -> keep(deviations, channel, values.toArray()));
        quaternions = b.quaternions.toArray();
        double[] turned = measured.getOrDefault(Channel.ORIENTATION, new double[0]);
        turns = IntStream.range(0, AXES).filter(axis -> isIn(turned, axis)).toArray();
        angles = new double[AXES * times.length];
        Arrays.fill(angles, Double.NaN);
        for (int k = 0; k < times.length; k++) {
            orientation(k).map(OrientationError::angles).ifPresent(write(angles, AXES * k));
        }
        accelerations = b.accelerations.toArray();
        rates = b.rates.toArray();
        frames = new EnumMap<>(b.frames);
        lasting = new EnumMap<>(Channel.class);
        b.lasting.forEach((channel, errors) -> lasting.put(channel, copy(errors)));
        commands = List.copyOf(b.commands());
        forces = List.copyOf(b.forces);
        start = b.start;
        differences = b.differences;
        beginsMidway = b.beginsMidway;
        whole = b.whole;
        uncut = b.uncut;
    }

    private static Consumer<Vec3> write(double[] to, int at) {
        return v -> {
            to[at] = v.x();
            to[at + 1] = v.y();
            to[at + 2] = v.z();
        };
    }

    private static Map<Integer, List<LastingError>> copy(Map<Integer, List<LastingError>> errors) {
        Map<Integer, List<LastingError>> copy = new TreeMap<>();
        errors.forEach((axis, of) -> copy.put(axis, List.copyOf(of)));
        return copy;
    }

    private static void keep(Map<Channel, double[]> to, Channel channel, double[] values) {
        if (Arrays.stream(values).anyMatch(Double::isFinite)) {
            to.put(channel, values);
        }
    }

    private static boolean isIn(double[] values, int axis) {
        return IntStream.range(0, values.length / AXES)
                .anyMatch(k -> !Double.isNaN(values[AXES * k + axis]));
    }

    /** An empty run of this name, to be filled. */
    public static MeasuredRunBuilder named(String name) {
        return new MeasuredRunBuilder(name);
    }

    /** For people, as that of its file. */
    public String name() {
        return name;
    }

    /** Number of samples. */
    public int size() {
        return times.length;
    }

    /** When a sample was taken (s). */
    public double time(int sample) {
        return times[sample];
    }

    /** The last sample at or before a time (s); the first if there is none. */
    public int sampleAt(double time) {
        int found = Arrays.binarySearch(times, time);
        return found >= 0 ? found : Math.max(0, -found - 2);
    }

    /** Whether it begins far from 0, as by UNIX time: then people count from its first row. */
    public boolean beginsFar() {
        return Math.abs(time(0)) > FAR;
    }

    /** Time from the first sample to the last (s). */
    public double duration() {
        return times[times.length - 1] - times[0];
    }

    /** Whether a channel was measured at all, be it along one axis alone. */
    public boolean measures(Channel channel) {
        return measured.containsKey(channel);
    }

    /** Whether a channel was ever measured along or about an axis (0 to 2). */
    public boolean measures(Channel channel, int axis) {
        for (int k = 0; k < size() && measures(channel); k++) {
            if (!Double.isNaN(value(channel, k, axis))) {
                return true;
            }
        }
        return false;
    }

    /**
     * A measured number, NaN where there is none. Of {@link Channel#ORIENTATION} it is not the
     * angle, but 0 where the turn about this axis was measured: {@link #orientation} has the value.
     */
    public double value(Channel channel, int sample, int axis) {
        double[] values = measured.get(channel);
        return values == null ? Double.NaN : values[AXES * sample + axis];
    }

    /** The samples at which a channel was measured along or about an axis (0 to 2), in order. */
    public int[] samples(Channel channel, int axis) {
        return IntStream.range(0, size())
                .filter(k -> !Double.isNaN(value(channel, k, axis)))
                .toArray();
    }

    /** Largest less smallest number along an axis (0 to 2); 0 if there is none. */
    public double range(Channel channel, int axis) {
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < size(); k++) {
            double value = value(channel, k, axis);
            if (!Double.isNaN(value)) {
                least = Math.min(least, value);
                most = Math.max(most, value);
            }
        }
        return Math.max(0, most - least);
    }

    /** The largest of these along the axes. */
    public double range(Channel channel) {
        return Math.max(range(channel, 0), Math.max(range(channel, 1), range(channel, 2)));
    }

    /** A measured vector, if all of it was measured. */
    public Optional<Vec3> vector(Channel channel, int sample) {
        Vec3 v =
                new Vec3(
                        value(channel, sample, 0),
                        value(channel, sample, 1),
                        value(channel, sample, 2));
        return v.isFinite() ? Optional.of(v) : Optional.empty();
    }

    /**
     * Length of a vector (the channel's unit) by the axes along which it was measured; NaN if it
     * was along none.
     */
    public double norm(Channel channel, int sample) {
        double square = Double.NaN;
        for (int axis = 0; axis < AXES; axis++) {
            double along = value(channel, sample, axis);
            if (!Double.isNaN(along)) {
                square = (Double.isNaN(square) ? 0 : square) + along * along;
            }
        }
        return Math.sqrt(square);
    }

    /** Body to world; what was not measured of it is as good as can be known. */
    public Optional<Quat> orientation(int sample) {
        int i = 4 * sample;
        return Double.isNaN(quaternions[i])
                ? Optional.empty()
                : Optional.of(
                        new Quat(
                                quaternions[i],
                                quaternions[i + 1],
                                quaternions[i + 2],
                                quaternions[i + 3]));
    }

    /** Whether the turns about all axes were measured at a sample. */
    boolean isWhollyOriented(int sample) {
        return !Double.isNaN(
                value(Channel.ORIENTATION, sample, 0)
                        + value(Channel.ORIENTATION, sample, 1)
                        + value(Channel.ORIENTATION, sample, 2));
    }

    /** Roll, pitch and yaw (rad) of its orientation; what was not measured is as in that. */
    Optional<Vec3> angles(int sample) {
        int i = AXES * sample;
        return Double.isNaN(angles[i])
                ? Optional.empty()
                : Optional.of(new Vec3(angles[i], angles[i + 1], angles[i + 2]));
    }

    /**
     * Whether the orientation was measured at a sample as far as it was at any: what others lack is
     * as in the scenario, and would be taken for a turn.
     */
    public boolean isOriented(int sample) {
        return orientation(sample).isPresent()
                && Arrays.stream(turns)
                        .noneMatch(axis -> Double.isNaN(value(Channel.ORIENTATION, sample, axis)));
    }

    /** The standard deviation that the data states of a number; NaN where it states none. */
    public double deviation(Channel channel, int sample, int axis) {
        double[] values = deviations.get(channel);
        return values == null ? Double.NaN : values[AXES * sample + axis];
    }

    /**
     * What an axis of an accelerometer told at a sample, which tells how the body shakes, in any
     * unit, as ratios count alone; NaN where there is none.
     */
    public double acceleration(int sample) {
        return accelerations[sample];
    }

    /** The same of a gyro. */
    public double rate(int sample) {
        return rates[sample];
    }

    /** Whether both were measured in any sample. */
    public boolean tellsShaking() {
        return IntStream.range(0, size())
                .anyMatch(k -> !Double.isNaN(accelerations[k]) && !Double.isNaN(rates[k]));
    }

    /** The axes in which velocities or turns of this channel were measured. */
    public Frame frame(Channel channel) {
        return frames.getOrDefault(channel, Frame.WORLD);
    }

    /** Errors of what a channel tells along or about an axis (0 to 2) that last over samples. */
    public List<LastingError> lastingErrors(Channel channel, int axis) {
        return lasting.getOrDefault(channel, Map.of()).getOrDefault(axis, List.of());
    }

    /** What the body was told, by actuator or force. */
    public List<Command> commands() {
        return commands;
    }

    /** Forces that acted for a while. */
    public List<ScheduledForce> forces() {
        return forces;
    }

    /** The motion at the first sample, if it is known otherwise than by the measurement. */
    public Optional<KnownStart> start() {
        return start;
    }

    /** The same, of whose start this is known. */
    public MeasuredRun startingAt(KnownStart known) {
        return MeasuredRunBuilder.startingAt(this, known);
    }

    /** The same, as if some of its numbers had not been measured. */
    public MeasuredRun without(Set<Reading> some) {
        return MeasuredRunBuilder.without(this, some);
    }

    /** The same, its positions (m, world; NaN where not measured) told otherwise. */
    public MeasuredRun placed(UnaryOperator<Vec3> otherwise) {
        return MeasuredRunBuilder.told(this, Channel.POSITION, otherwise);
    }

    /** The same, as if a channel had not been measured. */
    public MeasuredRun without(Channel channel) {
        Set<Reading> all = new HashSet<>();
        for (int k = 0; k < size(); k++) {
            for (int axis = 0; axis < AXES; axis++) {
                all.add(new Reading(channel, k, axis));
            }
        }
        return without(all);
    }

    /** The same, its orientations told otherwise. */
    public MeasuredRun turned(UnaryOperator<Quat> otherwise) {
        return MeasuredRunBuilder.turned(this, otherwise);
    }

    /** The same, its angular velocities (rad/s; NaN where not measured) told otherwise. */
    public MeasuredRun spinning(UnaryOperator<Vec3> otherwise) {
        return MeasuredRunBuilder.told(this, Channel.ANGULAR_VELOCITY, otherwise);
    }

    /** The same, two of its commands each told what the other was. */
    public MeasuredRun swapping(String one, String other) {
        return MeasuredRunBuilder.swapping(this, one, other);
    }

    /** What was known to be different in this run. */
    public KnownDifferences differences() {
        return differences;
    }

    /** The run that this is a part or a stretch of, as it was measured; itself, if it is none. */
    public MeasuredRun whole() {
        return whole.orElse(this);
    }

    /**
     * Whether the body was under way before, as in a part, or after a gap: nobody says that it
     * begins as the model has it.
     */
    public boolean beginsMidway() {
        return beginsMidway;
    }

    /** Whether it is one of the parts that a run was cut into; a stretch is none. */
    public boolean isPart() {
        return uncut.isPresent();
    }

    /** The run, or the stretch of one, that this is a part of; itself, if it is none. */
    public MeasuredRun uncut() {
        return uncut.orElse(this);
    }

    /** The part from one sample to another, both included; its known start only if it has it. */
    public MeasuredRun part(String name, int from, int to) {
        return MeasuredRunBuilder.part(this, name, from, to);
    }

    /**
     * The run cut into equal parts, each named after it and its number; itself, if in one.
     *
     * @param count how many, from 1 to one less than there are samples
     */
    public List<MeasuredRun> parts(int count) {
        if (count == 1) {
            return List.of(this);
        }
        List<MeasuredRun> parts = new ArrayList<>();
        long last = size() - 1L;
        for (int i = 0; i < count; i++) {
            int from = (int) (i * last / count);
            int to = (int) ((i + 1) * last / count);
            parts.add(part(name + "-" + (i + 1), from, to));
        }
        return List.copyOf(parts);
    }

    /** The same samples as the only ones that count, to be predicted like those of any run. */
    public MeasuredRun stretch(int from, int to) {
        return MeasuredRunBuilder.stretch(this, from, to);
    }
}
