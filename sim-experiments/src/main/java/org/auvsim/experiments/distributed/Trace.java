package org.auvsim.experiments.distributed;

import org.auvsim.core.world.World;
import org.auvsim.plot.page.Curve.Point;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;

/** A run, as it was watched: the distance of one sphere from the target, and the state's hashes. */
final class Trace {
    private static final long WATCHED = 1;

    private final String name;
    private final List<Point> distances = new ArrayList<>();
    private final List<Long> hashes = new ArrayList<>();

    Trace(String name) {
        this.name = name;
    }

    /** Notes where the world is after a step. */
    void note(World world) {
        double distance = world.object(WATCHED).position().distance(Scene.TARGET);
        distances.add(new Point(world.time(), distance));
        hashes.add(world.stateHash());
    }

    String name() {
        return name;
    }

    /** The distance (m) over time (s). */
    List<Point> distances() {
        return List.copyOf(distances);
    }

    /** The hash of the state that it ended in. */
    long lastHash() {
        return hashes.getLast();
    }

    /** The first step, counted from 1, after which the state is not the other's. */
    OptionalInt firstDifference(Trace other) {
        int common = Math.min(hashes.size(), other.hashes.size());
        for (int k = 0; k < common; k++) {
            if (!hashes.get(k).equals(other.hashes.get(k))) {
                return OptionalInt.of(k + 1);
            }
        }
        return hashes.size() == other.hashes.size()
                ? OptionalInt.empty()
                : OptionalInt.of(common + 1);
    }

    /** The largest difference (m) of the distance to the other's at the same step. */
    double largestDifference(Trace other) {
        double largest = 0;
        for (int k = 0; k < Math.min(distances.size(), other.distances.size()); k++) {
            double difference = distances.get(k).y() - other.distances.get(k).y();
            largest = Math.max(largest, Math.abs(difference));
        }
        return largest;
    }
}
