package org.auvsim.experiments.cfs;

import org.auvsim.core.world.World;
import org.auvsim.experiments.Conduct;
import org.auvsim.plot.page.Curve.Point;

import java.util.ArrayList;
import java.util.List;

/**
 * How far object A goes before it turns, ever farther: its push is switched on and off where it
 * looks, up to a step late, which gives it energy each time.
 *
 * @param timeStep (s)
 * @param turns distance (m) from the middle of each turning point, over time (s)
 */
record Growth(double timeStep, List<Point> turns) {
    /** Runs to a time (s), or until told to stop. */
    static Growth of(double timeStep, double until, Conduct conduct) {
        World world = Vehicle.toAndFro(timeStep);
        List<Point> turns = new ArrayList<>();
        double farthest = 0;
        while (world.time() < until && !conduct.isStopped()) {
            world.advanceTimestep();
            double distance = Math.abs(Vehicle.y(world));
            if (distance < Vehicle.LIMIT && farthest > Vehicle.LIMIT) {
                turns.add(new Point(world.time(), farthest));
                farthest = 0;
            }
            farthest = Math.max(farthest, distance);
        }
        return new Growth(timeStep, List.copyOf(turns));
    }

    double first() {
        return turns.getFirst().y();
    }

    double last() {
        return turns.getLast().y();
    }
}
