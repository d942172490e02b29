package org.auvsim.junit;

import org.auvsim.core.math.Vec3;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;

/**
 * Where a body went in a replay: as it was at the beginning and after each step. What it did inside
 * of a step is not seen, except that collisions are kept with their own times.
 */
public final class Trajectory {
    /** Sums of time steps round: so much (s) is no difference. */
    static final double SAME_TIME = 1e-9;

    private final Replay replay;
    private final Track track;

    Trajectory(Replay replay, Track track) {
        this.replay = replay;
        this.track = track;
    }

    /** The replay that it is of. */
    Replay replay() {
        return replay;
    }

    /** The body's id. */
    public long id() {
        return track.id();
    }

    /** The body's name. */
    public String name() {
        return track.name();
    }

    /** The body at the beginning and after each step; of a fixed one the first and the last. */
    public List<Sample> samples() {
        return track.samples();
    }

    /** Its first sample. */
    public Sample first() {
        return samples().getFirst();
    }

    /** Its last sample: at the replay's end, or before the body left the world. */
    public Sample last() {
        return samples().getLast();
    }

    /** Whether the body was in the world at a time (s). */
    public boolean isThereAt(double time) {
        return time >= first().time() - SAME_TIME && time <= last().time() + SAME_TIME;
    }

    /**
     * The body at a time (s), between two samples by linear interpolation.
     *
     * @throws IllegalArgumentException if it was not in the world then
     */
    public Sample at(double time) {
        if (!isThereAt(time)) {
            throw new IllegalArgumentException(
                    "'%s' was in the world from %s to %s s, not at %s s"
                            .formatted(name(), first().time(), last().time(), time));
        }
        int next = firstAfter(time);
        if (next == 0) {
            return first();
        }
        return next == samples().size()
                ? last()
                : samples().get(next - 1).towards(samples().get(next), time);
    }

    private int firstAfter(double time) {
        int low = 0;
        int high = samples().size();
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (samples().get(middle).time() > time) {
                high = middle;
            } else {
                low = middle + 1;
            }
        }
        return low;
    }

    /** How near its origin came to a point (m, world). */
    public Approach nearestTo(Vec3 point) {
        return nearest(samples(), time -> at(time).position().distance(point)).orElseThrow();
    }

    /** How near its origin came to that of another body; empty if the two never were together. */
    public Optional<Approach> nearestTo(Trajectory other) {
        List<Sample> denser =
                samples().size() >= other.samples().size() ? samples() : other.samples();
        return nearest(
                denser.stream()
                        .filter(s -> isThereAt(s.time()) && other.isThereAt(s.time()))
                        .toList(),
                time -> at(time).position().distance(other.at(time).position()));
    }

    private static Optional<Approach> nearest(List<Sample> when, DoubleUnaryOperator distance) {
        return when.stream()
                .map(s -> new Approach(s.time(), distance.applyAsDouble(s.time())))
                .min(Comparator.comparingDouble(Approach::distance));
    }

    /** Its collisions, in order of time. */
    public List<Encounter> collisions() {
        return replay.collisions().stream().filter(c -> c.involves(id())).toList();
    }

    /** Where the recording has it, of a fixed body nothing; empty if it is in no recording. */
    Optional<List<Pose>> recorded() {
        return track.recorded();
    }

    @Override
    public String toString() {
        return "'%s' (id %d), %s to %s s".formatted(name(), id(), first().time(), last().time());
    }
}
