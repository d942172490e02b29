package org.auvsim.viz.window;

import static java.util.Objects.requireNonNull;

import org.auvsim.core.math.Quat;
import org.auvsim.viz.scene.ActorView;
import org.auvsim.viz.scene.Angles;

import java.util.EnumMap;
import java.util.Map;

/** How an object has moved over the last minute of the world's time, its present state the last. */
final class History {
    static final double SECONDS = 60;

    /** A line leaves this share of a plot's height free above and below. */
    private static final double MARGIN = 0.08;

    private final double[] times;
    private final Map<Quantity, double[]> values = new EnumMap<>(Quantity.class);

    private History(int count) {
        times = new double[count];
        for (Quantity quantity : Quantity.values()) {
            values.put(quantity, new double[count]);
        }
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
        of(Quantity.X)[i] = x;
        of(Quantity.Y)[i] = y;
        of(Quantity.DEPTH)[i] = 0.0 - z;
        of(Quantity.SPEED)[i] = speed;
        of(Quantity.YAW)[i] = Math.toDegrees(yaw);
    }

    /** When the states were (s), the oldest first. */
    double[] times() {
        return times.clone();
    }

    private double[] of(Quantity quantity) {
        return requireNonNull(values.get(quantity));
    }

    /** A quantity of the same states. */
    double[] values(Quantity quantity) {
        return of(quantity).clone();
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

    /**
     * From where to where a plot of some quantities reaches; what hardly changes lies in the
     * middle.
     */
    double[] height(Quantity... of) {
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        double span = 0;
        for (Quantity quantity : of) {
            span = Math.max(span, quantity.span());
            for (double value : of(quantity)) {
                least = Math.min(least, value);
                most = Math.max(most, value);
            }
        }
        double half = (0.5 + MARGIN) * Math.max(most - least, span);
        double middle = (least + most) / 2;
        return new double[] {middle - half, middle + half};
    }
}
