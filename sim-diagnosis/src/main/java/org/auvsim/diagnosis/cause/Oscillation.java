package org.auvsim.diagnosis.cause;

import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;

/**
 * A vector that swings: theta is its sine (3), its cosine (3) and its angular frequency, of which
 * the first six are linear. It is told as the vector at the swing's end, frequency and phase; of an
 * ellipse, as its longer axis.
 */
final class Oscillation {
    /** Where the angular frequency is. */
    static final int OMEGA = 6;

    private final String name;
    private final String unit;
    private final List<Parameter> parameters;
    private final double[] frequencies;

    /** With this name for people; {@code scale} in its unit, begun at these frequencies (rad/s). */
    Oscillation(Setting s, String name, String unit, double scale, double[] frequencies) {
        this.name = name;
        this.unit = unit;
        this.frequencies = frequencies;
        parameters = new ArrayList<>(Parameter.vector("sine", unit, scale));
        parameters.addAll(Parameter.vector("cosine", unit, scale));
        parameters.add(new Frequencies(s).parameter());
    }

    List<Parameter> parameters() {
        return parameters;
    }

    /** One for each frequency of the grid. */
    List<Guess> guesses() {
        List<Guess> guesses = new ArrayList<>();
        for (double omega : frequencies) {
            guesses.add(
                    Change.guess(
                            parameters, new double[] {0, 0, 0, 0, 0, 0, omega}, 0, 1, 2, 3, 4, 5));
        }
        return guesses;
    }

    /** vector sin(omega t + phase), its largest component above 0. */
    List<Quantity> quantities(double[] theta) {
        Vec3 sine = new Vec3(theta[0], theta[1], theta[2]);
        Vec3 cosine = new Vec3(theta[3], theta[4], theta[5]);
        double phase =
                0.5 * StrictMath.atan2(2 * sine.dot(cosine), sine.dot(sine) - cosine.dot(cosine));
        Vec3 end = sine.times(StrictMath.cos(phase)).plus(cosine.times(StrictMath.sin(phase)));
        if (largest(end) < 0) {
            end = end.negated();
            phase += phase > 0 ? -Math.PI : Math.PI;
        }
        return List.of(
                new Quantity(name + ".x", unit, end.x()),
                new Quantity(name + ".y", unit, end.y()),
                new Quantity(name + ".z", unit, end.z()),
                new Quantity("omega", "rad/s", theta[OMEGA]),
                new Quantity("phase", "rad", phase));
    }

    private static double largest(Vec3 v) {
        double largest = Math.abs(v.y()) > Math.abs(v.x()) ? v.y() : v.x();
        return Math.abs(v.z()) > Math.abs(largest) ? v.z() : largest;
    }
}
