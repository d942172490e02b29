package org.auvsim.diagnosis.residual;

import org.auvsim.diagnosis.result.Axis;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.StringJoiner;
import java.util.stream.IntStream;

/**
 * Takes their power from outliers: where a channel has more numbers far off than a normal
 * distribution has, each is weighed as under Student's t with few degrees of freedom (Lange, Little
 * &amp; Taylor 1989), by how far it is off a cubic through its four neighbours: without any model.
 * So are those that are off together for a moment ({@link Bursts}). What a run states of a number's
 * error counts instead of the noise.
 */
public final class HeavyTails {
    private static final double FREEDOM = 4;

    /** This far off (in standard deviations) 6 of 100,000 normally distributed numbers are. */
    private static final double FAR = 4;

    private static final double MOST_FAR = 0.002;
    private static final int MOST_BY_CHANCE = 1;

    /** This far off no normally distributed number is. */
    private static final double ASTRAY = 6;

    /** Numbers that a cubic is taken of: each, and two to either side. */
    private static final int CUBIC = 5;

    private static final int TWO = 2;

    /** What two that are off together leave of each, by what one alone would. */
    private static final double OF_TWO = 3;

    /** By what they leave beside them: two thirds; two with two between them leave half there. */
    private static final double SHARE_OF_TWO = 0.58;

    /** Speeds may leap and come back, as in a collision; a place does not. */
    private static final Set<Channel> WITHOUT_LEAPS =
            EnumSet.of(Channel.POSITION, Channel.ORIENTATION);

    private HeavyTails() {}

    /** What motions miss of a run, outliers weighed less where there are many. */
    static Misses tamed(Misses of, Noise noise) {
        int rows = of.rows().size();
        double[] factors = new double[of.run().size() * rows];
        boolean[] outliers = new boolean[factors.length];
        Arrays.fill(factors, 1);
        for (int row = 0; row < rows; row++) {
            OfRow tail = new OfRow(of.run(), of.rows().get(row), noise);
            for (int i = 0; i < tail.series.size(); i++) {
                int number = tail.series.sample(i) * rows + row;
                factors[number] = tail.factors[i];
                outliers[number] = tail.outliers[i];
            }
        }
        return of.weighed(factors, outliers);
    }

    /** What is told of the outliers of a run; empty where it has no more than chance brings. */
    public static Optional<String> notice(MeasuredRun run, List<Misses.Row> rows, Noise noise) {
        StringJoiner of = new StringJoiner(", ");
        for (Misses.Row row : rows) {
            OfRow tail = new OfRow(run, row, noise);
            if (tail.count() > 0) {
                of.add(
                        "%d of %d numbers of %s"
                                .formatted(
                                        tail.count(),
                                        tail.series.size(),
                                        Axis.of(run, row.channel(), row.axis())
                                                .brief(row.channel())));
            }
        }
        return of.length() == 0
                ? Optional.empty()
                : Optional.of(
                        "%s: outliers, given less weight and left out of errors: %s"
                                .formatted(run.name(), of));
    }

    /** Which numbers of a row are outliers, and by what all of them are to be multiplied. */
    private static final class OfRow {
        final Series series;
        final double[] factors;
        final boolean[] outliers;

        OfRow(MeasuredRun run, Misses.Row row, Noise noise) {
            series = Series.of(run, row.channel(), row.axis());
            factors = new double[series.size()];
            outliers = new boolean[series.size()];
            Arrays.fill(factors, 1);
            double deviation = noise.of(row.channel(), row.axis());
            double[] off = off(series, deviation);
            double share = series.statesDeviations() ? usual(off) : 1;
            weighAlone(Arrays.stream(off).map(z -> z / share).toArray());
            if (WITHOUT_LEAPS.contains(row.channel())) {
                weighTogether(Bursts.off(series, deviation, share));
            }
        }

        private void weighAlone(double[] off) {
            if (hasOutliers(off)) {
                for (int i = 0; i < off.length; i++) {
                    factors[i + CUBIC / 2] = factor(off[i]);
                    outliers[i + CUBIC / 2] = isBeyond(FAR, i, off);
                }
                for (int i = 0; i + TWO + 1 < off.length; i++) {
                    if (isAroundTwo(i, off)) {
                        blameTheTwoAfter(i, off);
                    }
                }
            }
        }

        /** Not the one before them and the one behind, which they leave off to the other side. */
        private void blameTheTwoAfter(int before, double[] off) {
            for (int i = before; i <= before + TWO + 1; i++) {
                boolean isOfTwo = i > before && i <= before + TWO;
                factors[i + CUBIC / 2] = isOfTwo ? factor(OF_TWO * off[i]) : 1;
                outliers[i + CUBIC / 2] = isOfTwo;
            }
        }

        private void weighTogether(double[] off) {
            for (int i = 0; i < off.length; i++) {
                if (off[i] != 0) {
                    factors[i] = factor(off[i]);
                    outliers[i] = true;
                }
            }
        }

        long count() {
            return IntStream.range(0, outliers.length).filter(i -> outliers[i]).count();
        }
    }

    /**
     * By how many standard deviations numbers are off, but for the first two and the last.
     *
     * @param ofRow standard deviation of those of which the run states none
     */
    private static double[] off(Series series, double ofRow) {
        return IntStream.range(0, Math.max(0, series.size() - CUBIC + 1))
                .mapToDouble(i -> series.difference(i, CUBIC) / series.deviation(i, CUBIC, ofRow))
                .toArray();
    }

    /** What most numbers are off makes no outlier, though less was stated. */
    private static double usual(double[] off) {
        double[] sizes = Arrays.stream(off).map(Math::abs).toArray();
        return Math.max(1, MedianAbsoluteDeviation.standardDeviation(sizes));
    }

    private static boolean hasOutliers(double[] off) {
        return beyond(FAR, off) > Math.max(MOST_BY_CHANCE, MOST_FAR * off.length)
                || beyond(ASTRAY, off) > 0;
    }

    private static int beyond(double limit, double[] off) {
        return (int) IntStream.range(0, off.length).filter(i -> isBeyond(limit, i, off)).count();
    }

    private static boolean isBeyond(double limit, int i, double[] off) {
        return Math.abs(off[i]) > limit && isAlone(i, off);
    }

    /**
     * Whether it is off and not those beside it: then these are off to the other side, by less. A
     * motion that bends more than a cubic leaves several off to the same.
     */
    private static boolean isAlone(int i, double[] off) {
        return (i == 0 || isLess(off[i - 1], off[i]))
                && (i + 1 == off.length || isLess(off[i + 1], off[i]));
    }

    /**
     * Whether it and the third after it are off because the two between them are, alike: of fourth
     * differences two such leave 1, -3, 2, 2, -3, 1 where one leaves 1, -4, 6, -4, 1.
     */
    private static boolean isAroundTwo(int i, double[] off) {
        double before = off[i];
        double behind = off[i + TWO + 1];
        return isBeyond(FAR, i, off)
                && isBeyond(FAR, i + TWO + 1, off)
                && before * behind > 0
                && before * off[i + 1] < 0
                && before * off[i + TWO] < 0
                && -(off[i + 1] + off[i + TWO]) / (before + behind) > SHARE_OF_TWO;
    }

    private static boolean isLess(double beside, double off) {
        return beside * off <= 0 && Math.abs(beside) <= Math.abs(off);
    }

    private static double factor(double z) {
        return Math.sqrt((FREEDOM + 1) / (FREEDOM + z * z));
    }
}
