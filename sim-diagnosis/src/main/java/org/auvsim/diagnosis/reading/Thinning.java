package org.auvsim.diagnosis.reading;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * Takes, of each stretch of so many rows, the first number of each column that is measured. So
 * columns that have a number in each row stay evenly spaced, and such as have one now and then, as
 * that of a fix of the position among the rows of a fast sensor, lose none that are further apart.
 */
final class Thinning {
    private static final long NEVER = -1;

    /** Places of what is measured, and of what tells of shaking. */
    private static final int[] MEASURED =
            IntStream.concat(
                            IntStream.range(Slots.POSITION, Slots.DEVIATIONS),
                            IntStream.range(Slots.SHAKING, Slots.COMMANDS))
                    .toArray();

    private final long each;
    private final long[] stretches = new long[Slots.COMMANDS];
    private double[] taken = {};

    /** Of so many rows; of 1 all are taken as they are. */
    Thinning(long each) {
        this.each = each;
        restart();
    }

    /** The next row is the first of a stretch. */
    void restart() {
        Arrays.fill(stretches, NEVER);
    }

    /**
     * Whether something of a row is taken.
     *
     * @param row of which number, from 0 on since the restart
     */
    boolean takes(long row, double[] numbers) {
        if (each == 1) {
            taken = numbers;
            return true;
        }
        taken = numbers.clone();
        boolean isAny = false;
        for (int slot : MEASURED) {
            if (Double.isNaN(numbers[slot]) || stretches[slot] == row / each) {
                taken[slot] = Double.NaN;
            } else {
                stretches[slot] = row / each;
                isAny = true;
            }
        }
        return isAny;
    }

    /** What is taken of the last row that was asked for, by {@link Slots}. */
    double[] taken() {
        return taken;
    }
}
