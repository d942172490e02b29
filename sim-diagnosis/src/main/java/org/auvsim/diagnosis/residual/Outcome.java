package org.auvsim.diagnosis.residual;

import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.server.feedback.RigidMotion;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * What a hypothesis misses of runs that are simulated in one go.
 *
 * @param misses of each run, sample by sample, in standard deviations
 * @param squares what they come to by channel
 * @param stated channels whose errors are at least as large as is stated
 * @param known squared distance of starts and parameters from what is known of them
 * @param independent how many independent numbers tell as much as those that were measured
 */
public record Outcome(
        List<double[]> misses,
        Map<Channel, Squares> squares,
        Set<Channel> stated,
        double known,
        double independent) {
    /** Mean squares below this share of the noise's are told from it by rounding alone. */
    static final double EXACT = 0.01;

    /** Of no numbers. */
    public static final Squares NOTHING = new Squares(0, 0);

    /** A sum of squares, and of how many numbers. */
    public record Squares(double sum, int count) {
        /** Of these numbers and others. */
        public Squares plus(Squares other) {
            return new Squares(sum + other.sum, count + other.count);
        }

        private Squares plus(double miss) {
            return new Squares(sum + miss * miss, count + 1);
        }

        /** Below what rounding does it means nothing how small it is. */
        public double mean() {
            return Math.max(sum / count, EXACT);
        }

        /** Twice the negative logarithm of the likelihood of noise that is as large as they are. */
        private double deviance() {
            return count * StrictMath.log(mean());
        }

        /** The same of noise that is as large as was thought, or larger. */
        private double devianceFromStated() {
            return mean() > 1 ? count + deviance() : sum;
        }
    }

    /**
     * Of some runs.
     *
     * @param misses of each, in standard deviations, row by row within each sample
     * @param known squares by which starts and numbers are off from what is known of them
     */
    public static Outcome of(List<Misses> data, List<double[]> misses, double known) {
        Map<Channel, Squares> squares = squares(data, misses);
        Set<Channel> stated = EnumSet.noneOf(Channel.class);
        for (Misses of : data) {
            of.rows().stream().filter(of::isStated).map(Misses.Row::channel).forEach(stated::add);
        }
        double independent = data.stream().mapToDouble(Misses::independent).sum();
        return new Outcome(misses, squares, stated, known, independent);
    }

    /** What misses of each run come to by channel. */
    public static Map<Channel, Squares> squares(List<Misses> data, List<double[]> misses) {
        Map<Channel, Squares> squares = new EnumMap<>(Channel.class);
        for (int r = 0; r < data.size(); r++) {
            List<Misses.Row> rows = data.get(r).rows();
            for (int row = 0; row < rows.size(); row++) {
                Squares sum = squares.getOrDefault(rows.get(row).channel(), NOTHING);
                double[] ofRun = misses.get(r);
                for (int i = row; i < ofRun.length; i += rows.size()) {
                    if (data.get(r).isMeasured(i)) {
                        sum = sum.plus(ofRun[i]);
                    }
                }
                squares.put(rows.get(row).channel(), sum);
            }
        }
        return squares;
    }

    /** Sum of squares. */
    public static double squares(double[] misses) {
        double sum = 0;
        for (double miss : misses) {
            sum += miss * miss;
        }
        return sum;
    }

    /** Squared distance of a start from what is known of it, in standard deviations. */
    public static double squares(KnownStart known, RigidMotion start) {
        return squares(misses(known, start));
    }

    /** How far a start is from what is known of it, in standard deviations; 0 where nothing is. */
    public static double[] misses(KnownStart known, RigidMotion start) {
        double[] off = start.minus(known.motion());
        for (int i = 0; i < off.length; i++) {
            off[i] /= known.deviations().get(i);
        }
        return off;
    }

    /** That of a channel; none if it was not measured. */
    public Squares of(Channel channel) {
        return squares.getOrDefault(channel, NOTHING);
    }

    /** All squares: what a fit makes as small as it can. Infinite if the motion got lost. */
    public double cost() {
        double cost = known;
        for (Squares ofChannel : squares.values()) {
            cost += ofChannel.sum();
        }
        return Double.isNaN(cost) ? Double.POSITIVE_INFINITY : cost;
    }

    /** How many numbers were measured. */
    public int count() {
        return squares.values().stream().mapToInt(Squares::count).sum();
    }

    /** Mean square of a channel, but not below what is stated. */
    public double expected(Channel channel) {
        return stated.contains(channel) ? Math.max(1, of(channel).mean()) : of(channel).mean();
    }

    /**
     * Twice the negative logarithm of the likelihood, each channel's noise as large as its misses
     * are, but not below what is stated.
     */
    public double deviance() {
        double sum = known;
        for (Map.Entry<Channel, Squares> of : squares.entrySet()) {
            boolean isStated = stated.contains(of.getKey());
            sum += isStated ? of.getValue().devianceFromStated() : of.getValue().deviance();
        }
        return Double.isNaN(sum) ? Double.POSITIVE_INFINITY : sum;
    }
}
