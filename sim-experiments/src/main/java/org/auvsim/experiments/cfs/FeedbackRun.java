package org.auvsim.experiments.cfs;

import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.auvsim.experiments.live.LiveRun;
import org.auvsim.experiments.live.Participant;
import org.auvsim.plot.page.Curve.Point;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * What came of a robot's feedback.
 *
 * @param simulated where its object was along y (m) after each step, over time (s)
 * @param told where the robot said that it was
 */
record FeedbackRun(String name, List<Point> simulated, List<Point> told) {
    static FeedbackRun of(String name, LiveRun run, World world, Telling robot) throws IOException {
        List<Point> simulated = new ArrayList<>();
        run.run(
                world,
                List.of(new Participant(Vehicle.ID, Vec3.ZERO, robot)),
                now -> simulated.add(new Point(now.time(), Vehicle.y(now))));
        return new FeedbackRun(name, List.copyOf(simulated), robot.told());
    }

    /** How far (m) the object was from where the robot said to be at the same time (s). */
    List<Point> errors() {
        List<Point> errors = new ArrayList<>();
        int at = 0;
        for (Point place : told) {
            while (at < simulated.size() && simulated.get(at).x() < place.x()) {
                at++;
            }
            if (at < simulated.size() && simulated.get(at).x() == place.x()) {
                errors.add(new Point(place.x(), simulated.get(at).y() - place.y()));
            }
        }
        return errors;
    }

    /** The root of the mean square of these (m). */
    double rmsError() {
        return Math.sqrt(errors().stream().mapToDouble(e -> e.y() * e.y()).average().orElse(0));
    }

    /** The largest of these (m). */
    double largestError() {
        return errors().stream().mapToDouble(e -> Math.abs(e.y())).max().orElse(0);
    }

    /** The time (s) of the largest of these. */
    double timeOfLargestError() {
        return errors().stream()
                .max(Comparator.comparingDouble(e -> Math.abs(e.y())))
                .map(Point::x)
                .orElse(0.0);
    }

    /** The share of steps, from 0 to 1, in which the object stood still. */
    double standstill() {
        long still = 0;
        for (int k = 1; k < simulated.size(); k++) {
            still += simulated.get(k).y() == simulated.get(k - 1).y() ? 1 : 0;
        }
        return (double) still / Math.max(1, simulated.size() - 1);
    }
}
