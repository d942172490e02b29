package org.auvsim.diagnosis.reading;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Angles as the rows of a file tell them, beside the rates of turning: a heading is the integral of
 * its rate, if both are told in the same unit and about the same axis. Where no rate says so,
 * angles that make jumps from row to row are hardly radians.
 */
final class AnglesAndRates {
    private static final int YAW = Slots.ANGLES + 2;
    private static final int RATE = Slots.ANGULAR_VELOCITY + 2;
    private static final int FEWEST = 16;

    /** So well (correlation) a heading goes together with its rate. */
    private static final double TOGETHER = 0.9;

    /** A heading may turn so many times as far as its rate says, as a body that pitches does. */
    private static final double ALIKE = 2;

    private static final double DEGREES = 180 / Math.PI;

    /** The same, where one of them is in degrees. */
    private static final double NEARLY_DEGREES = 1.2;

    /** Few bodies turn as fast (rad/s). */
    private static final double FAST = 10;

    /** More than this (rad) from row to row is a jump; a whole turn is none. */
    private static final double JUMP = Math.PI / 2;

    private static final double NEARLY_A_TURN = 0.8;

    /** This share of the changes may be jumps. */
    private static final double MOST_JUMPS = 0.25;

    private final Proportion inRadians = new Proportion();
    private final Proportion inDegrees = new Proportion();
    private final int[] changes = new int[3];
    private final int[] jumps = new int[3];
    private final double[] before = {Double.NaN, Double.NaN, Double.NaN};
    private double turns;
    private double turnsOfDegrees;
    private double rate = Double.NaN;
    private double fastest;
    private double since;
    private double turned;

    /** A row begins another run. */
    void restart() {
        Arrays.fill(before, Double.NaN);
        rate = Double.NaN;
    }

    /** The numbers of a row by {@link Slots}, at a time (s). */
    void add(double time, double[] row) {
        double now = row[RATE];
        if (!Double.isNaN(now)) {
            turned += Double.isNaN(rate) ? 0 : (now + rate) / 2 * (time - since);
            rate = now;
            fastest = Math.max(fastest, Math.abs(now));
            since = time;
        }
        for (int axis = 0; axis < changes.length; axis++) {
            double angle = row[Slots.ANGLES + axis];
            if (!Double.isNaN(angle)) {
                if (!Double.isNaN(before[axis])) {
                    change(axis, angle - before[axis]);
                }
                before[axis] = angle;
            }
        }
        if (!Double.isNaN(row[YAW]) && !Double.isNaN(now)) {
            inRadians.add(turned, row[YAW] + turns);
            inDegrees.add(turned, row[YAW] + turnsOfDegrees);
        }
    }

    private void change(int axis, double by) {
        changes[axis]++;
        double size = Math.abs(by);
        boolean isATurn = Math.abs(size - 2 * Math.PI) < NEARLY_A_TURN || size > Math.PI * DEGREES;
        jumps[axis] += size > JUMP && !isATurn ? 1 : 0;
        if (Slots.ANGLES + axis == YAW) {
            turns -= 2 * Math.PI * Math.rint(by / (2 * Math.PI));
            turnsOfDegrees -= 360 * Math.rint(by / 360);
        }
    }

    /** Whether a rate that is none of degrees says that the heading is in the same unit as it. */
    boolean areRadians() {
        return agree() && fastest < FAST;
    }

    private boolean agree() {
        return inRadians.correlation() > TOGETHER && isAbout(inRadians, 1, ALIKE);
    }

    private static boolean isAbout(Proportion of, double slope, double times) {
        double ratio = of.slope() / slope;
        return of.count() >= FEWEST && ratio > 1 / times && ratio < times;
    }

    /** What of the heading and its rate cannot be, in words. */
    Optional<String> contradiction() {
        if (agree()) {
            return Optional.empty();
        }
        if (isOtherUnit()) {
            return Optional.of(
                    "one turns 57 times as far as the other says: is one of them in degrees and the other in radians? If so, map that one with a scale of %s (--mapping)"
                            .formatted(Figures.shown(1 / DEGREES, 6)));
        }
        return inRadians.correlation() < -TOGETHER && isAbout(inRadians, -1, ALIKE)
                ? Optional.of(
                        "one turns the other way than the other says: is one of them positive"
                                + " clockwise? If so, map that one with a scale of -1 (--mapping)")
                : Optional.empty();
    }

    /** The columns of the heading and its rate. */
    List<String> columns(Source source) {
        return List.of(source.named(YAW), source.named(RATE));
    }

    /** The columns of angles that make jumps. */
    List<String> jumping(Source source) {
        return IntStream.range(0, changes.length)
                .filter(axis -> changes[axis] >= FEWEST)
                .filter(axis -> jumps[axis] > MOST_JUMPS * changes[axis])
                .mapToObj(axis -> source.named(Slots.ANGLES + axis))
                .toList();
    }

    /** Either way round. */
    private boolean isOtherUnit() {
        return (inDegrees.correlation() > TOGETHER && isAbout(inDegrees, DEGREES, NEARLY_DEGREES))
                || (inRadians.correlation() > TOGETHER
                        && isAbout(inRadians, 1 / DEGREES, NEARLY_DEGREES));
    }
}
