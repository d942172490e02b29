package org.auvsim.experiments.hidden;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/**
 * How it really is: the body, the water, what pushes, and what sensors make of it. Immutable.
 *
 * @param companions each begins anew with every run
 * @param edges times (s) at which something sets in
 */
record Reality(
        Plant plant,
        Water water,
        List<Force> forces,
        List<Function<SplittableRandom, Companion>> companions,
        List<Double> edges,
        Sensors sensors) {
    /** A body in still water. */
    static Reality of(Plant plant) {
        return new Reality(plant, Water.STILL, List.of(), List.of(), List.of(), Sensors.TRUE);
    }

    Reality with(UnaryOperator<Plant> change) {
        return new Reality(change.apply(plant), water, forces, companions, edges, sensors);
    }

    Reality in(Water more) {
        return new Reality(plant, water.plus(more), forces, companions, edges, sensors);
    }

    Reality pushed(Force force) {
        return new Reality(plant, water, plus(forces, force), companions, edges, sensors);
    }

    Reality accompanied(Function<SplittableRandom, Companion> companion) {
        return new Reality(plant, water, forces, plus(companions, companion), edges, sensors);
    }

    Reality edge(double time) {
        return new Reality(plant, water, forces, companions, plus(edges, time), sensors);
    }

    Reality sensed(UnaryOperator<Sensors> change) {
        return new Reality(plant, water, forces, companions, edges, change.apply(sensors));
    }

    private static <T> List<T> plus(List<T> list, T more) {
        List<T> all = new ArrayList<>(list);
        all.add(more);
        return List.copyOf(all);
    }
}
