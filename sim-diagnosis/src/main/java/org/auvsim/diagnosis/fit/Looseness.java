package org.auvsim.diagnosis.fit;

import org.apache.commons.math3.stat.descriptive.rank.Percentile;
import org.apache.commons.math3.util.ResizableDoubleArray;
import org.auvsim.core.math.Quat;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * How far the start of a window may be from a guess: as much as the whole run moves, no more. A
 * short window alone does not tell velocities from noise, and a model that is asked for motions
 * which the run never had, as fast spins, gets lost or stiff. Least of all may turns move that were
 * not measured: a window would tumble for a path that the model misses.
 */
final class Looseness {
    private static final double SHARE_OF_RANGE = 0.1;
    private static final double NOISES = 10;

    /** Of an orientation (rad), and of a body's rates (m/s, rad/s) that nothing was measured of. */
    private static final double TURN = 0.3;

    private static final double UNKNOWN_SPEED = 10;
    private static final double UNKNOWN_RATE = 3;
    private static final double LEAST_SPEED = 0.01;
    private static final double LEAST_RATE = 0.1;

    /** What is not measured stays this much nearer to where the window before has led. */
    private static final double UNSEEN = 0.1;

    /** Rates are seen over this time (s). */
    private static final double WHILE = 0.4;

    /**
     * So many percent of the rates are lower than what is taken for the largest, but for a factor.
     */
    private static final double MOST = 90;

    private static final double LARGER = 2;

    private Looseness() {}

    /** Standard deviations of a start, as {@link org.auvsim.diagnosis.run.KnownStart} has them. */
    static List<Double> of(MeasuredRun run, Noise noise) {
        double place = SHARE_OF_RANGE * range(run) + NOISES * noise.of(Channel.POSITION);
        double turn = TURN + NOISES * noise.of(Channel.ORIENTATION);
        double speed = rate(run, Channel.POSITION, UNKNOWN_SPEED, LEAST_SPEED);
        double spin = rate(run, Channel.ORIENTATION, UNKNOWN_RATE, LEAST_RATE);
        List<Double> deviations = new ArrayList<>();
        for (int i = 0; i < RigidMotion.SIZE; i++) {
            deviations.add(List.of(place, turn, speed, spin).get(i / 3));
        }
        return deviations;
    }

    /** The same of a start to which another window has led. */
    static List<Double> afterwards(MeasuredRun run, List<Double> looseness) {
        List<Double> deviations = new ArrayList<>(looseness);
        for (int axis = 0; axis < 3; axis++) {
            if (!run.measures(Channel.ORIENTATION, axis)
                    && !run.measures(Channel.ANGULAR_VELOCITY)) {
                deviations.set(3 + axis, UNSEEN * looseness.get(3 + axis));
                deviations.set(9 + axis, UNSEEN * looseness.get(9 + axis));
            }
        }
        return deviations;
    }

    /** The rate that a channel hardly exceeds, seen over a while. */
    private static double rate(MeasuredRun run, Channel channel, double unknown, double least) {
        ResizableDoubleArray rates = new ResizableDoubleArray();
        int before = 0;
        for (int k = 1; k < run.size() && run.measures(channel); k++) {
            double duration = run.time(k) - run.time(before);
            if (duration >= WHILE) {
                double way = way(run, channel, before, k);
                if (!Double.isNaN(way)) {
                    rates.addElement(way / duration);
                }
                before = k;
            }
        }
        if (rates.getNumElements() == 0) {
            return unknown;
        }
        return Math.max(least, LARGER * new Percentile(MOST).evaluate(rates.getElements()));
    }

    private static double way(MeasuredRun run, Channel channel, int from, int to) {
        if (channel == Channel.ORIENTATION) {
            Optional<Quat> before = run.orientation(from);
            Optional<Quat> after = run.orientation(to);
            return before.isPresent() && after.isPresent()
                    ? Misses.turn(before.get(), after.get()).norm()
                    : Double.NaN;
        }
        double squares = 0;
        for (int axis = 0; axis < 3; axis++) {
            double way = run.value(channel, to, axis) - run.value(channel, from, axis);
            squares += run.measures(channel, axis) ? way * way : 0;
        }
        return Math.sqrt(squares);
    }

    /** The largest extent of the motion along an axis (m). */
    static double range(MeasuredRun run) {
        double range = 0;
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int k = 0; k < run.size(); k++) {
                double place = run.value(Channel.POSITION, k, axis);
                if (!Double.isNaN(place)) {
                    low = Math.min(low, place);
                    high = Math.max(high, place);
                }
            }
            range = Math.max(range, high - low);
        }
        return range;
    }
}
