package org.auvsim.diagnosis.residual;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Whether residuals are noise: those of a good model have no memory, so that means over blocks of
 * them are as small as chance makes them, and none is like the next. Each channel is scaled by its
 * own deviation, so that a wrong estimate of the noise is not taken for a cause.
 */
public final class Whiteness {
    private static final int[] BLOCKS = {4, 8, 16, 32};

    /** Where more than this share of the squares lasts to the next sample, they may be motion. */
    private static final double LASTING = 0.5;

    /** So many deviations of the noise are more than errors of a sensor that last. */
    private static final double FAR_ABOVE_NOISE = 3;

    /** No estimate of the noise is too small by this factor, or by as many samples. */
    private static final double BEYOND_NOISE = 5;

    private static final int FEWEST = 16;

    /** Above this a channel is not white: of noise, one in 30,000 block sums is. */
    public static final double LIMIT = 4;

    private Whiteness() {}

    /**
     * How unlikely the largest of the block sums of any channel of runs is, or that of all of them
     * together, as a normal deviate: what each channel hides in its noise many of them tell.
     *
     * @param misses of each run, sample by sample
     * @param of what they are of; what is stated of its errors may last, too
     */
    public static double largest(List<double[]> misses, List<Misses> of) {
        BlockSums together = new BlockSums();
        double largest = 0;
        for (int r = 0; r < of.size(); r++) {
            largest = Math.max(largest, largest(misses.get(r), of.get(r), together));
        }
        return Math.max(largest, together.largestBeyondShort());
    }

    /** Sums of squares of the means over blocks, by their deviation, and how many, by length. */
    private static final class BlockSums {
        private final double[] squares = new double[BLOCKS.length];
        private final int[] blocks = new int[BLOCKS.length];

        /** Those of a channel. */
        void add(double[] values, double deviation) {
            for (int i = 0; i < BLOCKS.length; i++) {
                int length = BLOCKS[i];
                int count = values.length / length;
                double sum = 0;
                for (int b = 0; b < count; b++) {
                    double ofBlock = 0;
                    for (int k = 0; k < length; k++) {
                        ofBlock += values[b * length + k];
                    }
                    sum += ofBlock * ofBlock;
                }
                squares[i] += sum / (length * deviation * deviation);
                blocks[i] += count;
            }
        }

        void add(BlockSums other) {
            for (int i = 0; i < BLOCKS.length; i++) {
                squares[i] += other.squares[i];
                blocks[i] += other.blocks[i];
            }
        }

        /** The largest deviate of any length. */
        double largest() {
            return largest(1);
        }

        /**
         * The same beyond what the shortest blocks have, as do longer ones of errors that last for
         * a row or two: those of a sensor, of which many channels would tell the least.
         */
        double largestBeyondShort() {
            return blocks[0] == 0 ? 0 : largest(Math.max(1, squares[0] / blocks[0]));
        }

        private double largest(double usual) {
            double largest = 0;
            for (int i = 0; i < BLOCKS.length; i++) {
                double deviate = blocks[i] < 2 ? 0 : deviate(squares[i] / usual, blocks[i]);
                largest = Math.max(largest, deviate);
            }
            return largest;
        }
    }

    /**
     * That of the channels of a run.
     *
     * @param together where their blocks are counted, too
     */
    private static double largest(double[] misses, Misses of, BlockSums together) {
        double largest = 0;
        for (int row = 0; row < of.rows().size(); row++) {
            double[] ofChannel = row(misses, row, of);
            double own = deviation(ofChannel);
            double deviation = of.isStated(of.rows().get(row)) ? Math.max(1, own) : own;
            if (own * own < Outcome.EXACT) {
                continue; // without noise
            }
            if (!of.isStated(of.rows().get(row))) {
                largest = Math.max(largest, beyondNoise(ofChannel));
            }
            BlockSums sums = new BlockSums();
            sums.add(ofChannel, deviation);
            together.add(sums);
            largest = Math.max(largest, sums.largest());
            largest = Math.max(largest, lasting(ofChannel, deviation));
        }
        return largest;
    }

    /** Those that were measured. */
    private static double[] row(double[] misses, int row, Misses of) {
        int rows = of.rows().size();
        return IntStream.range(0, misses.length / rows)
                .map(k -> k * rows + row)
                .filter(of::isMeasured)
                .mapToDouble(i -> misses[i])
                .toArray();
    }

    private static double deviation(double[] values) {
        double sum = 0;
        for (double value : values) {
            sum += value * value;
        }
        return Math.sqrt(sum / values.length);
    }

    /**
     * So many times the noise, if most are that large: angles that are far off are as random as
     * noise. Few that are, as outliers, are none of the model's.
     */
    private static double beyondNoise(double[] values) {
        if (values.length < FEWEST) {
            return 0;
        }
        double usual =
                MedianAbsoluteDeviation.standardDeviation(
                        Arrays.stream(values).map(Math::abs).toArray());
        return usual > BEYOND_NOISE ? usual : 0;
    }

    /**
     * That of the correlation of each with the next, where they are large and alike: what swings to
     * and fro within a block has small means, and of few samples there are few blocks.
     */
    private static double lasting(double[] values, double deviation) {
        double sum = 0;
        for (int k = 1; k < values.length; k++) {
            sum += values[k - 1] * values[k];
        }
        double correlation = sum / (deviation * deviation * values.length);
        return deviation > FAR_ABOVE_NOISE && correlation > LASTING
                ? correlation * Math.sqrt(values.length)
                : 0;
    }

    /**
     * A chi square as a normal deviate (Wilson &amp; Hilferty 1931): of few degrees of freedom its
     * tail is long.
     */
    public static double deviate(double chiSquare, int freedom) {
        double variance = 2 / (9.0 * freedom);
        return (StrictMath.cbrt(chiSquare / freedom) - (1 - variance)) / Math.sqrt(variance);
    }
}
