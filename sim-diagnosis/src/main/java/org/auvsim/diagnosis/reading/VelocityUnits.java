package org.auvsim.diagnosis.reading;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Measured positions beside measured velocities: along each axis one should be the integral of the
 * other. Only where they go together, but one 1000 times as far, a unit is suspected: noise of a
 * body that stays where it is does not.
 */
final class VelocityUnits {
    /** A unit that is off by 1000 makes ratios within these. */
    private static final double LEAST = 300;

    private static final double MOST = 3000;
    private static final int FEWEST = 8;

    /** So well (correlation) they must go together. */
    private static final double TOGETHER = 0.9;

    private final MeasuredRun run;

    VelocityUnits(MeasuredRun run) {
        this.run = run;
    }

    /**
     * Axes along which positions go 1000 times as far as velocities say, or as little.
     *
     * @param ratio of positions to the integrals of velocities
     */
    record Suspicion(List<Integer> axes, double ratio) {}

    /** What is suspected, if anything is. */
    Optional<Suspicion> suspicion() {
        List<Integer> axes = new ArrayList<>();
        double ratio = Double.NaN;
        boolean isKnown = false;
        for (int axis = 0; axis < 3; axis++) {
            Proportion pairs = along(axis);
            isKnown |= pairs.count() >= FEWEST;
            boolean goTogether = pairs.correlation() >= TOGETHER;
            if (pairs.count() >= FEWEST && isOff(pairs.slope()) && goTogether) {
                axes.add(axis);
                ratio = pairs.slope();
            }
        }
        if (axes.isEmpty()) {
            return isKnown ? Optional.empty() : bySpeed();
        }
        return Optional.of(new Suspicion(axes, ratio));
    }

    private static boolean isOff(double ratio) {
        return (ratio >= LEAST && ratio <= MOST) || (ratio >= 1 / MOST && ratio <= 1 / LEAST);
    }

    /** Of the integral of the velocity, positions. */
    private Proportion along(int axis) {
        Proportion pairs = new Proportion();
        double integral = 0;
        double before = Double.NaN;
        double since = Double.NaN;
        for (int k = 0; k < run.size(); k++) {
            double velocity = velocity(k, axis);
            if (!Double.isNaN(velocity)) {
                double step = run.time(k) - since;
                integral += Double.isNaN(before) ? 0 : (velocity + before) / 2 * step;
                before = velocity;
                since = run.time(k);
                double position = run.value(Channel.POSITION, k, axis);
                if (!Double.isNaN(position)) {
                    pairs.add(integral, position);
                }
            }
        }
        return pairs;
    }

    /** In the world's axes; NaN if it is not known in them. */
    private double velocity(int k, int axis) {
        if (run.frame(Channel.VELOCITY) == Frame.WORLD) {
            return run.value(Channel.VELOCITY, k, axis);
        }
        Optional<Vec3> inBody = run.vector(Channel.VELOCITY, k);
        return inBody.isPresent() && run.orientation(k).isPresent()
                ? run.orientation(k).get().rotate(inBody.get()).component(axis)
                : Double.NaN;
    }

    /** Where it is not known how the body is turned: the way that it goes, beside its speed. */
    private Optional<Suspicion> bySpeed() {
        double way = 0;
        double told = 0;
        double farthest = 0;
        Optional<Vec3> first = Optional.empty();
        for (int k = 1; k < run.size(); k++) {
            Optional<Vec3> from = run.vector(Channel.POSITION, k - 1);
            Optional<Vec3> to = run.vector(Channel.POSITION, k);
            Optional<Vec3> velocity = run.vector(Channel.VELOCITY, k);
            if (from.isPresent() && to.isPresent() && velocity.isPresent()) {
                first = first.or(() -> from);
                farthest = Math.max(farthest, to.get().distance(first.get()));
                way += to.get().distance(from.get());
                told += velocity.get().norm() * (run.time(k) - run.time(k - 1));
            }
        }
        // Noise makes a way longer, not what is farthest; and never shorter.
        double ratio = farthest > LEAST * told ? farthest / told : way / told;
        boolean isSure = ratio < 1 || farthest > LEAST * told;
        return isOff(ratio) && isSure
                ? Optional.of(new Suspicion(List.of(0, 1, 2), ratio))
                : Optional.empty();
    }
}
