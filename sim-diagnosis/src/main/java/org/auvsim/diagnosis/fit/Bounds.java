package org.auvsim.diagnosis.fit;

import org.auvsim.diagnosis.cause.Parameter;

import java.util.Arrays;
import java.util.List;

/** How far numbers may be moved and still make sense. */
public final class Bounds {
    private final double[] least;
    private final double[] most;

    /**
     * Of changes.
     *
     * @param least the lowest of each, 0 or less
     * @param most the highest, 0 or more
     */
    private Bounds(double[] least, double[] most) {
        this.least = least;
        this.most = most;
    }

    /** Of parameters that have these numbers now. */
    public static Bounds of(List<Parameter> parameters, double[] numbers) {
        double[] least = new double[numbers.length];
        double[] most = new double[numbers.length];
        for (int i = 0; i < numbers.length; i++) {
            least[i] = Math.min(0, parameters.get(i).lowest() - numbers[i]);
            most[i] = Math.max(0, parameters.get(i).highest() - numbers[i]);
        }
        return new Bounds(least, most);
    }

    /** Those of some of the numbers. */
    public Bounds of(int[] some) {
        return new Bounds(
                Arrays.stream(some).mapToDouble(i -> least[i]).toArray(),
                Arrays.stream(some).mapToDouble(i -> most[i]).toArray());
    }

    /** The nearest change of one of them that makes sense. */
    double clipped(int i, double change) {
        return Math.max(least[i], Math.min(most[i], change));
    }
}
