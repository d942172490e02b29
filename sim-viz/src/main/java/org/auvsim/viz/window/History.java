package org.auvsim.viz.window;

import org.auvsim.core.math.Quat;
import org.auvsim.viz.scene.ActorView;
import org.auvsim.viz.scene.Angles;

import java.util.Arrays;

/** How an object has moved over the last minute of the world's time, its present state the last. */
final class History {
    static final double SECONDS = 60;

    private final double[] times;
    private final double[][] values;

    private History(int count) {
        times = new double[count];
        values = new double[Quantity.values().length][count];
    }

    /** An object's, as it is shown at a time (s). */
    static History of(ActorView actor, double time) {
        int from = 0;
        while (from < actor.trailLength() && actor.trailTime(from) < time - SECONDS) {
            from++;
        }
        int to = from;
        while (to < actor.trailLength() && actor.trailTime(to) < time) {
            to++;
        }
        History history = new History(to - from + 1);
        for (int i = from; i < to; i++) {
            history.set(
                    i - from,
                    actor.trailTime(i),
                    actor.trail(i, 0),
                    actor.trail(i, 1),
                    actor.trail(i, 2),
                    actor.trailSpeed(i),
                    actor.trailYaw(i));
        }
        history.setPresent(to - from, actor, time);
        return history;
    }

    private void setPresent(int i, ActorView actor, double time) {
        Quat turn =
                new Quat(
                        actor.orientation(0),
                        actor.orientation(1),
                        actor.orientation(2),
                        actor.orientation(3));
        double speed =
                Math.hypot(Math.hypot(actor.velocity(0), actor.velocity(1)), actor.velocity(2));
        set(
                i,
                time,
                actor.position(0),
                actor.position(1),
                actor.position(2),
                speed,
                Angles.rollPitchYaw(turn)[2]);
    }

    private void set(int i, double time, double x, double y, double z, double speed, double yaw) {
        times[i] = time;
        values[Quantity.X.ordinal()][i] = x;
        values[Quantity.Y.ordinal()][i] = y;
        values[Quantity.DEPTH.ordinal()][i] = 0.0 - z;
        values[Quantity.SPEED.ordinal()][i] = speed;
        values[Quantity.YAW.ordinal()][i] = Math.toDegrees(yaw);
    }

    /** When the states were (s), the oldest first. */
    double[] times() {
        return times.clone();
    }

    /** A quantity of the same states. */
    double[] values(Quantity quantity) {
        return values[quantity.ordinal()].clone();
    }

    /** A quantity as a line: none is drawn from 180 to -180 degrees. */
    double[] line(Quantity quantity) {
        double[] line = values(quantity);
        if (quantity == Quantity.YAW) {
            for (int i = line.length - 1; i > 0; i--) {
                if (Math.abs(line[i] - line[i - 1]) > 180) {
                    line[i] = Double.NaN;
                }
            }
        }
        return line;
    }

    /** The smallest value of some quantities. */
    double least(Quantity... of) {
        return Arrays.stream(of)
                .flatMapToDouble(q -> Arrays.stream(values[q.ordinal()]))
                .min()
                .orElse(0);
    }

    /** The largest value of some quantities. */
    double most(Quantity... of) {
        return Arrays.stream(of)
                .flatMapToDouble(q -> Arrays.stream(values[q.ordinal()]))
                .max()
                .orElse(0);
    }
}
