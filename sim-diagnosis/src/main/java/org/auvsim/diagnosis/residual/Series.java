package org.auvsim.diagnosis.residual;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.OrientationError;

import java.util.OptionalDouble;
import java.util.stream.IntStream;

/**
 * The numbers that were measured along or about one axis of a run, one after the other. There may
 * be fewer of them than rows, and they may be unevenly far apart.
 */
final class Series {
    /** Intervals that differ by less than this share are even: times are rounded, too. */
    private static final double EVEN = 1e-6;

    /** The same for what only asks how many rows ago something was. */
    private static final double NEARLY_EVEN = 0.01;

    private final MeasuredRun run;
    private final Channel channel;
    private final int axis;
    private final int[] samples;

    private Series(MeasuredRun run, Channel channel, int axis, int[] samples) {
        this.run = run;
        this.channel = channel;
        this.axis = axis;
        this.samples = samples;
    }

    /** Those along or about an axis (0 to 2). */
    static Series of(MeasuredRun run, Channel channel, int axis) {
        return new Series(run, channel, axis, run.samples(channel, axis));
    }

    /** How many there are. */
    int size() {
        return samples.length;
    }

    /** The sample of the run in which a number was measured. */
    int sample(int i) {
        return samples[i];
    }

    /** How much a number differs from the one before; of an orientation the turn (rad). */
    double change(int i) {
        int before = samples[i - 1];
        int after = samples[i];
        return channel == Channel.ORIENTATION
                ? turn(run.orientation(before).orElseThrow(), run.orientation(after).orElseThrow())
                        .component(axis)
                : run.value(channel, after, axis) - run.value(channel, before, axis);
    }

    /** How far each number is from the first, all changes on the way together. */
    double[] levels() {
        double[] levels = new double[samples.length];
        for (int i = 1; i < levels.length; i++) {
            levels[i] = levels[i - 1] + change(i);
        }
        return levels;
    }

    private Vec3 turn(Quat before, Quat after) {
        Vec3 turn = OrientationError.turn(before, after);
        return run.frame(channel) == Frame.BODY ? before.rotateInverse(turn) : turn;
    }

    /**
     * A divided difference (Newton) of successive numbers: of a polynomial in time whose degree is
     * below their number less one it has nothing, of noise as much as differences with binomial
     * coefficients have, which it is where they are evenly far apart.
     */
    double difference(int from, int count) {
        double[] weights = weights(from, count);
        double sum = 0;
        double beyondFirst = 0;
        for (int j = 1; j < count; j++) {
            beyondFirst += change(from + j);
            sum += weights[j] * beyondFirst;
        }
        return sum;
    }

    /**
     * The standard deviation of such a difference: by those that the run states of the numbers, and
     * by the noise where it states none.
     */
    double deviation(int from, int count, double noise) {
        double[] weights = weights(from, count);
        double sum = 0;
        for (int j = 0; j < count; j++) {
            double stated = stated(from + j);
            double of = weights[j] * (Double.isNaN(stated) ? noise : stated);
            sum += of * of;
        }
        return Math.sqrt(sum);
    }

    /** Whether the run states the standard deviation of any of the numbers. */
    boolean statesDeviations() {
        return IntStream.range(0, samples.length).anyMatch(i -> !Double.isNaN(stated(i)));
    }

    /** The standard deviation that the run states of a number; NaN where it states none. */
    double stated(int i) {
        return run.deviation(channel, samples[i], axis);
    }

    private double[] weights(int from, int count) {
        double[] weights = new double[count];
        double binomial = 1;
        double squares = 0;
        for (int j = 0; j < count; j++) {
            weights[j] = (count - 1 - j) % 2 == 0 ? binomial : -binomial;
            squares += binomial * binomial;
            binomial = binomial * (count - 1 - j) / (j + 1);
        }
        return isEven(from, count) ? weights : divided(from, count, squares);
    }

    private boolean isEven(int from, int count) {
        double shortest = Double.POSITIVE_INFINITY;
        double longest = 0;
        for (int j = 1; j < count; j++) {
            double interval = time(from + j) - time(from + j - 1);
            shortest = Math.min(shortest, interval);
            longest = Math.max(longest, interval);
        }
        return longest - shortest <= EVEN * longest;
    }

    /** The reciprocals of the products of a time's distances from the others, scaled. */
    private double[] divided(int from, int count, double squares) {
        double usual = (time(from + count - 1) - time(from)) / (count - 1);
        double[] weights = new double[count];
        double sum = 0;
        for (int j = 0; j < count; j++) {
            double product = 1;
            for (int m = 0; m < count; m++) {
                product *= m == j ? 1 : (time(from + j) - time(from + m)) / usual;
            }
            weights[j] = 1 / product;
            sum += weights[j] * weights[j];
        }
        double scale = Math.sqrt(squares / sum);
        for (int j = 0; j < count; j++) {
            weights[j] *= scale;
        }
        return weights;
    }

    /** From each number to the next (s), if all are evenly far apart. */
    OptionalDouble interval() {
        double mean = (time(size() - 1) - time(0)) / (size() - 1);
        for (int i = 1; i < size(); i++) {
            if (Math.abs(time(i) - time(i - 1) - mean) > NEARLY_EVEN * mean) {
                return OptionalDouble.empty();
            }
        }
        return OptionalDouble.of(mean);
    }

    /** Whether both have the same interval, if they have one. */
    boolean isAsFarApart(Series other) {
        OptionalDouble own = interval();
        OptionalDouble others = other.interval();
        return own.isPresent()
                && others.isPresent()
                && Math.abs(own.getAsDouble() - others.getAsDouble())
                        < NEARLY_EVEN * own.getAsDouble();
    }

    /** The standard deviation of what a sensor that counts in steps leaves out; or 0. */
    double rounding() {
        return Resolution.deviation(IntStream.range(1, size()).mapToDouble(this::change).toArray());
    }

    /** How often a number differs from the one before. */
    int steps() {
        return (int) IntStream.range(1, size()).filter(i -> change(i) != 0).count();
    }

    /** When a number was measured (s). */
    double time(int i) {
        return run.time(samples[i]);
    }
}
