package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.server.feedback.RigidMotion;

import java.util.List;

/**
 * What a hypothesis misses of runs that are simulated in one go.
 *
 * @param misses of each run, sample by sample, in standard deviations
 * @param squares their sum of squares by channel
 * @param counts how many numbers each channel has
 * @param known squared distance of starts and parameters from what is known of them
 */
record Outcome(List<double[]> misses, double[] squares, int[] counts, double known) {
    /** Mean squares below this share of the noise's are told from it by rounding alone. */
    static final double EXACT = 0.01;

    static Outcome of(List<Misses> data, List<double[]> misses, double known) {
        double[] squares = new double[Channel.values().length];
        int[] counts = new int[squares.length];
        for (int r = 0; r < data.size(); r++) {
            List<Misses.Row> rows = data.get(r).rows();
            double[] ofRun = misses.get(r);
            for (int i = 0; i < ofRun.length; i++) {
                if (!data.get(r).isMeasured(i)) {
                    continue;
                }
                int channel = rows.get(i % rows.size()).channel().ordinal();
                squares[channel] += ofRun[i] * ofRun[i];
                counts[channel]++;
            }
        }
        return new Outcome(misses, squares, counts, known);
    }

    /** Squared distance of a start from what is known of it, in standard deviations. */
    static double squares(KnownStart known, RigidMotion start) {
        double[] off = start.minus(known.motion());
        double sum = 0;
        for (int i = 0; i < off.length; i++) {
            double share = off[i] / known.deviations().get(i);
            sum += share * share;
        }
        return sum;
    }

    /** All squares: what a fit makes as small as it can. Infinite if the motion got lost. */
    double cost() {
        double cost = known;
        for (double square : squares) {
            cost += square;
        }
        return Double.isNaN(cost) ? Double.POSITIVE_INFINITY : cost;
    }

    /** How many numbers were measured. */
    int count() {
        int sum = 0;
        for (int count : counts) {
            sum += count;
        }
        return sum;
    }

    /**
     * Twice the negative logarithm of the likelihood, each channel's noise as large as its misses
     * are.
     */
    double deviance() {
        double sum = known;
        for (int c = 0; c < squares.length; c++) {
            if (counts[c] > 0) {
                sum += counts[c] * Math.log(Math.max(squares[c] / counts[c], EXACT));
            }
        }
        return Double.isNaN(sum) ? Double.POSITIVE_INFINITY : sum;
    }
}
