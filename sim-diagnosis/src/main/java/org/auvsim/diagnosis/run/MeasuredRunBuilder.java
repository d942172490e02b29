package org.auvsim.diagnosis.run;

import org.apache.commons.math3.util.ResizableDoubleArray;
import org.auvsim.auvsml.run.LastingError;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;

/** Takes a run sample by sample: {@link #at} begins one, the rest fills it. */
public final class MeasuredRunBuilder {
    private static final int AXES = 3;
    private static final double[] NOTHING = {Double.NaN, Double.NaN, Double.NaN};

    final String name;
    final Numbers times = new Numbers();
    final Map<Channel, Numbers> measured = new EnumMap<>(Channel.class);
    final Map<Channel, Numbers> deviations = new EnumMap<>(Channel.class);
    final Numbers quaternions = new Numbers();
    final Numbers accelerations = new Numbers();
    final Numbers rates = new Numbers();
    final Map<Channel, Frame> frames = new EnumMap<>(Channel.class);
    final Map<Channel, Map<Integer, List<LastingError>>> lasting = new EnumMap<>(Channel.class);
    final List<ScheduledForce> forces = new ArrayList<>();
    Optional<KnownStart> start = Optional.empty();
    KnownDifferences differences = KnownDifferences.NONE;
    boolean beginsMidway;
    Optional<MeasuredRun> whole = Optional.empty();
    Optional<MeasuredRun> uncut = Optional.empty();
    private final List<String> commandNames = new ArrayList<>();
    private final List<Numbers> levels = new ArrayList<>();
    private double last = Double.NEGATIVE_INFINITY;

    /** Doubles in a row. */
    static final class Numbers {
        private final ResizableDoubleArray values = new ResizableDoubleArray();

        void add(double... more) {
            for (double number : more) {
                values.addElement(number); // addElements copies all there are
            }
        }

        void setLast(int from, double[] last) {
            set(values.getNumElements() - from, last);
        }

        void set(int first, double[] some) {
            for (int i = 0; i < some.length; i++) {
                values.setElement(first + i, some[i]);
            }
        }

        int size() {
            return values.getNumElements();
        }

        double[] toArray() {
            return values.getElements();
        }
    }

    MeasuredRunBuilder(String name) {
        this.name = name;
        for (Channel channel : Channel.values()) {
            measured.put(channel, new Numbers());
            deviations.put(channel, new Numbers());
        }
    }

    /** Names what is commanded; before the first sample. */
    public MeasuredRunBuilder commands(List<String> names) {
        for (String command : names) {
            commandNames.add(command);
            levels.add(new Numbers());
        }
        return this;
    }

    /**
     * Begins a sample at a time (s).
     *
     * @throws IllegalArgumentException if it is not after the last one
     */
    public MeasuredRunBuilder at(double time) {
        if (!(time > last)) {
            throw new IllegalArgumentException(
                    "times must increase, but %s s follows %s s".formatted(time, last));
        }
        last = time;
        times.add(time);
        measured.values().forEach(values -> values.add(NOTHING));
        deviations.values().forEach(values -> values.add(NOTHING));
        quaternions.add(Double.NaN, Double.NaN, Double.NaN, Double.NaN);
        accelerations.add(Double.NaN);
        rates.add(Double.NaN);
        levels.forEach(level -> level.add(0));
        return this;
    }

    /** Position (m, world); NaN where a coordinate was not measured. */
    public MeasuredRunBuilder position(double x, double y, double z) {
        return measured(Channel.POSITION, x, y, z);
    }

    /** Orientation, body to world, wholly measured. */
    public MeasuredRunBuilder orientation(Quat q) {
        return orientation(q, true, true, true);
    }

    /** Orientation, of which the turns about some axes were measured: of its {@link #frame}. */
    public MeasuredRunBuilder orientation(Quat q, boolean x, boolean y, boolean z) {
        Quat unit = q.normalized();
        quaternions.setLast(4, new double[] {unit.w(), unit.x(), unit.y(), unit.z()});
        return measured(
                Channel.ORIENTATION, x ? 0 : Double.NaN, y ? 0 : Double.NaN, z ? 0 : Double.NaN);
    }

    /** Velocity (m/s) or angular velocity (rad/s), in the axes that {@link #frame} tells. */
    public MeasuredRunBuilder measured(Channel channel, double x, double y, double z) {
        of(measured, channel).setLast(3, new double[] {x, y, z});
        return this;
    }

    /**
     * What tells how the body shakes, as it was measured: one axis of an accelerometer and one of a
     * gyro, in any units that are the same in all runs; NaN where there is none.
     */
    public MeasuredRunBuilder shaking(double acceleration, double rate) {
        accelerations.setLast(1, new double[] {acceleration});
        rates.setLast(1, new double[] {rate});
        return this;
    }

    /** There is one for each channel. */
    private static Numbers of(Map<Channel, Numbers> numbers, Channel channel) {
        return Objects.requireNonNull(numbers.get(channel));
    }

    /** Standard deviations of what this sample measured, in its channel's units. */
    public MeasuredRunBuilder deviation(Channel channel, double x, double y, double z) {
        of(deviations, channel).setLast(3, new double[] {x, y, z});
        return this;
    }

    /** What an actuator or force is told from this sample on. */
    public MeasuredRunBuilder command(int index, double level) {
        levels.get(index).setLast(1, new double[] {level});
        return this;
    }

    /** In whose axes a velocity or a turn is measured; the world's, if nothing is said. */
    public MeasuredRunBuilder frame(Channel channel, Frame frame) {
        frames.put(channel, frame);
        return this;
    }

    /**
     * One more error of what a channel tells along or about an axis (0 to 2) that lasts over
     * samples.
     */
    public MeasuredRunBuilder lastingError(Channel channel, int axis, LastingError error) {
        lasting.computeIfAbsent(channel, _ -> new TreeMap<>())
                .computeIfAbsent(axis, _ -> new ArrayList<>())
                .add(error);
        return this;
    }

    /** A force that acted for a while. */
    public MeasuredRunBuilder force(ScheduledForce force) {
        forces.add(force);
        return this;
    }

    /** How the body moved at the first sample, as far as it is known. */
    public MeasuredRunBuilder start(KnownStart known) {
        start = Optional.of(known);
        return this;
    }

    /** What was known to be different in this run. */
    public MeasuredRunBuilder differences(KnownDifferences known) {
        differences = known;
        return this;
    }

    List<Command> commands() {
        List<Command> commands = new ArrayList<>();
        for (int i = 0; i < commandNames.size(); i++) {
            commands.add(new Command(commandNames.get(i), levels.get(i).toArray()));
        }
        return commands;
    }

    /** It goes on after a gap: the body was under way before. */
    public MeasuredRunBuilder beginningMidway() {
        beginsMidway = true;
        return this;
    }

    /**
     * The run.
     *
     * @throws IllegalArgumentException if it has fewer than two samples
     */
    public MeasuredRun build() {
        if (times.size() < 2) {
            throw new IllegalArgumentException(
                    "run '%s' has fewer than two samples; nothing moves in it".formatted(name));
        }
        return new MeasuredRun(this);
    }

    static MeasuredRun part(MeasuredRun run, String name, int from, int to) {
        MeasuredRunBuilder part = copy(run, name, from, to);
        part.uncut = Optional.of(run.uncut());
        return part.build();
    }

    static MeasuredRun stretch(MeasuredRun run, int from, int to) {
        return copy(run, run.name(), from, to).build();
    }

    static MeasuredRun startingAt(MeasuredRun run, KnownStart known) {
        return copy(run, run.name(), 0, run.size() - 1).start(known).build();
    }

    static MeasuredRun without(MeasuredRun run, Set<Reading> some) {
        MeasuredRunBuilder copy =
                copy(run, run.name(), 0, run.size() - 1, reading -> !some.contains(reading));
        if (run.whole().equals(run)) {
            copy.whole = Optional.empty();
        }
        return copy.build();
    }

    static MeasuredRun told(MeasuredRun run, Channel channel, UnaryOperator<Vec3> otherwise) {
        MeasuredRunBuilder copy = copy(run, run.name(), 0, run.size() - 1);
        for (int k = 0; run.measures(channel) && k < run.size(); k++) {
            double x = run.value(channel, k, 0);
            double y = run.value(channel, k, 1);
            double z = run.value(channel, k, 2);
            Vec3 told = otherwise.apply(new Vec3(x, y, z));
            of(copy.measured, channel).set(AXES * k, new double[] {told.x(), told.y(), told.z()});
        }
        return copy.build();
    }

    static MeasuredRun turned(MeasuredRun run, UnaryOperator<Quat> otherwise) {
        MeasuredRunBuilder copy = copy(run, run.name(), 0, run.size() - 1);
        for (int k = 0; k < run.size(); k++) {
            int first = 4 * k;
            run.orientation(k)
                    .map(otherwise)
                    .ifPresent(
                            q ->
                                    copy.quaternions.set(
                                            first, new double[] {q.w(), q.x(), q.y(), q.z()}));
        }
        return copy.build();
    }

    static MeasuredRun swapping(MeasuredRun run, String one, String other) {
        MeasuredRunBuilder copy = copy(run, run.name(), 0, run.size() - 1);
        copy.commandNames.replaceAll(
                name -> name.equals(one) ? other : name.equals(other) ? one : name);
        copy.whole =
                run.whole().equals(run)
                        ? Optional.empty()
                        : Optional.of(swapping(run.whole(), one, other));
        return copy.build();
    }

    private static MeasuredRunBuilder copy(MeasuredRun run, String name, int from, int to) {
        return copy(run, name, from, to, _ -> true);
    }

    private static double value(
            MeasuredRun run, Channel channel, int sample, int axis, Predicate<Reading> isKept) {
        return isKept.test(new Reading(channel, sample, axis))
                ? run.value(channel, sample, axis)
                : Double.NaN;
    }

    private static MeasuredRunBuilder copy(
            MeasuredRun run, String name, int from, int to, Predicate<Reading> isKept) {
        MeasuredRunBuilder part =
                new MeasuredRunBuilder(name)
                        .commands(run.commands().stream().map(Command::name).toList());
        for (Channel channel : Channel.values()) {
            part.frame(channel, run.frame(channel));
            for (int axis = 0; axis < AXES; axis++) {
                for (LastingError error : run.lastingErrors(channel, axis)) {
                    part.lastingError(channel, axis, error);
                }
            }
        }
        for (int k = from; k <= to; k++) {
            part.at(run.time(k));
            for (Channel channel : Channel.values()) {
                part.measured(
                        channel,
                        value(run, channel, k, 0, isKept),
                        value(run, channel, k, 1, isKept),
                        value(run, channel, k, 2, isKept));
                part.deviation(
                        channel,
                        run.deviation(channel, k, 0),
                        run.deviation(channel, k, 1),
                        run.deviation(channel, k, 2));
            }
            part.shaking(run.acceleration(k), run.rate(k));
            run.orientation(k).ifPresent(part::keepOrientation);
            for (int c = 0; c < run.commands().size(); c++) {
                part.command(c, run.commands().get(c).level(k));
            }
        }
        part.beginsMidway = from > 0 || run.beginsMidway();
        part.whole = Optional.of(run.whole());
        part.uncut = run.isPart() ? Optional.of(run.uncut()) : Optional.empty();
        run.forces().forEach(part::force);
        if (from == 0) {
            run.start().ifPresent(part::start);
        }
        return part.differences(run.differences());
    }

    private void keepOrientation(Quat q) {
        quaternions.setLast(4, new double[] {q.w(), q.x(), q.y(), q.z()});
    }
}
