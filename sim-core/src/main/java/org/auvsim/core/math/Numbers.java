package org.auvsim.core.math;

import java.util.Arrays;

/** Numbers in a row: an immutable value. */
public final class Numbers {
    private final double[] values;
    private final double greatest;

    private Numbers(double[] values) {
        this.values = values;
        double most = Double.NEGATIVE_INFINITY;
        for (double value : values) {
            most = Math.max(most, value);
        }
        greatest = most;
    }

    /** These numbers. */
    public static Numbers of(double... values) {
        return new Numbers(values.clone());
    }

    /** How many there are. */
    public int size() {
        return values.length;
    }

    /**
     * Number {@code i}, from 0 on.
     *
     * @throws IndexOutOfBoundsException if there is none
     */
    public double get(int i) {
        return values[i];
    }

    /** The greatest of them; minus infinity if there are none. */
    public double greatest() {
        return greatest;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Numbers numbers && Arrays.equals(values, numbers.values);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(values);
    }

    @Override
    public String toString() {
        return Arrays.toString(values);
    }
}
