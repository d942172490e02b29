package org.auvsim.diagnosis.online;

import org.apache.commons.math3.linear.RealMatrix;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.Target;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

import java.util.ArrayList;
import java.util.Collection;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.OptionalDouble;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;

/** What a learner has heard of its object, as measured runs. Bounded: the oldest makes room. */
final class Logbook {
    private static final Logger LOG = LoggerFactory.getLogger(Logbook.class);

    /** A run with fewer measured samples tells too little. */
    private static final int LEAST_SAMPLES = 24;

    /**
     * What a time has.
     *
     * @param measured what told of a channel last: a robot may tell each by a message of its own
     * @param levels what was told from then on
     */
    private record Entry(Map<Channel, Target> measured, SortedMap<String, Double> levels) {}

    private final int most;
    private final List<NavigableMap<Double, Entry>> runs = new ArrayList<>();
    private final Map<String, NamedForce> forces = new LinkedHashMap<>();
    private OptionalDouble measuredUntil = OptionalDouble.empty();
    private double newTime;
    private boolean isFull;

    /** Keeps so many samples at most. */
    Logbook(int most) {
        this.most = most;
        runs.add(new TreeMap<>());
    }

    void add(Observation observation) {
        switch (observation) {
            case Observation.Told told -> {
                told.forces().forEach(force -> forces.putIfAbsent(force.name(), force));
                runs.getLast()
                        .merge(
                                told.time(),
                                new Entry(Map.of(), told.levels()),
                                (old, now) -> new Entry(old.measured(), now.levels()));
            }
            case Observation.Measured measured -> add(measured);
            case Observation.Broken _ -> {
                runs.add(new TreeMap<>());
                measuredUntil = OptionalDouble.empty();
            }
        }
        forget();
    }

    private void add(Observation.Measured measured) {
        double until = measuredUntil.orElse(measured.time());
        newTime += Math.max(0, measured.time() - until);
        measuredUntil = OptionalDouble.of(Math.max(until, measured.time()));
        NavigableMap<Double, Entry> run = runs.getLast();
        Map.Entry<Double, Entry> before = run.floorEntry(measured.time());
        Map<Channel, Target> all = new EnumMap<>(Channel.class);
        if (before != null && before.getKey() == measured.time()) {
            all.putAll(before.getValue().measured());
        }
        channels(measured.target()).forEach(channel -> all.put(channel, measured.target()));
        run.put(
                measured.time(),
                new Entry(all, before == null ? new TreeMap<>() : before.getValue().levels()));
    }

    private void forget() {
        while (runs.stream().mapToInt(Map::size).sum() > most) {
            if (!isFull) {
                LOG.info("more than {} samples were measured: the oldest are forgotten", most);
                isFull = true;
            }
            runs.getFirst().pollFirstEntry();
            if (runs.getFirst().isEmpty()) {
                runs.removeFirst();
            }
        }
    }

    /** For how long (s) something was measured since {@link #read}. */
    double newTime() {
        return newTime;
    }

    /** What is in it has been read. */
    void read() {
        newTime = 0;
    }

    /** The forces that were ever told something. */
    Collection<NamedForce> forces() {
        return forces.values();
    }

    /** What is in it. */
    List<MeasuredRun> runs() {
        List<MeasuredRun> all = new ArrayList<>();
        for (NavigableMap<Double, Entry> run : runs) {
            long samples = run.values().stream().filter(e -> !e.measured().isEmpty()).count();
            if (samples >= LEAST_SAMPLES) {
                all.add(run("feedback " + (all.size() + 1), run));
            }
        }
        return all;
    }

    private static MeasuredRun run(String name, NavigableMap<Double, Entry> entries) {
        SortedSet<String> told = new TreeSet<>();
        entries.values().forEach(entry -> told.addAll(entry.levels().keySet()));
        List<String> commands = List.copyOf(told);
        MeasuredRunBuilder run = MeasuredRun.named(name).commands(commands);
        boolean hasBegun = false;
        for (Map.Entry<Double, Entry> at : entries.entrySet()) {
            Entry entry = at.getValue();
            hasBegun |= !entry.measured().isEmpty();
            if (hasBegun) {
                run.at(at.getKey());
                entry.measured().forEach((channel, target) -> measure(run, channel, target));
                for (int c = 0; c < commands.size(); c++) {
                    run.command(c, entry.levels().getOrDefault(commands.get(c), 0.0));
                }
            }
        }
        return run.build();
    }

    private static void measure(MeasuredRunBuilder run, Channel channel, Target target) {
        switch (channel) {
            case POSITION -> target.position().ifPresent(p -> measure(run, channel, p));
            case ORIENTATION -> target.orientation().ifPresent(run::orientation);
            case VELOCITY -> target.velocity().ifPresent(v -> measure(run, channel, v));
            case ANGULAR_VELOCITY ->
                    target.angularVelocity().ifPresent(w -> measure(run, channel, w));
        }
        int row = 3 * channels(target).indexOf(channel);
        target.covariance().ifPresent(covariance -> deviations(run, channel, covariance, row));
    }

    private static void measure(MeasuredRunBuilder run, Channel channel, Vec3 value) {
        run.measured(channel, value.x(), value.y(), value.z());
    }

    /**
     * Along each axis of the world, as the target has them.
     *
     * @param row the first of the channel
     */
    private static void deviations(
            MeasuredRunBuilder run, Channel channel, RealMatrix covariance, int row) {
        run.deviation(
                channel,
                Math.sqrt(covariance.getEntry(row, row)),
                Math.sqrt(covariance.getEntry(row + 1, row + 1)),
                Math.sqrt(covariance.getEntry(row + 2, row + 2)));
    }

    /** In the order of the covariance. */
    private static List<Channel> channels(Target target) {
        List<Channel> channels = new ArrayList<>();
        target.position().ifPresent(_ -> channels.add(Channel.POSITION));
        target.orientation().ifPresent(_ -> channels.add(Channel.ORIENTATION));
        target.velocity().ifPresent(_ -> channels.add(Channel.VELOCITY));
        target.angularVelocity().ifPresent(_ -> channels.add(Channel.ANGULAR_VELOCITY));
        return channels;
    }
}
