package org.auvsim.diagnosis.cause;

import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A vector that swings: theta is its sine (3), its cosine (3) and its angular frequency, of which
 * the first six are linear. Sine and cosine count from where the runs begin: so their phase hardly
 * changes with the frequency, whatever the clock shows. It is told as the vector at the swing's
 * end, frequency and phase by the world's time; of an ellipse, as its longer axis.
 */
final class Oscillation {
    /** Where the angular frequency is. */
    static final int OMEGA = 6;

    private final String name;
    private final String unit;
    private final List<Parameter> parameters;
    private final Frequencies frequencies;
    private final double begin;

    /** That of a force. */
    static Oscillation ofForce(Setting s) {
        List<Parameter> linear = new ArrayList<>(s.forces("sine", "N", s.force()));
        linear.addAll(s.forces("cosine", "N", s.force()));
        return new Oscillation(s, "force", "N", linear);
    }

    /** That of a current, which a body feels from all sides; {@code scale} in m/s. */
    static Oscillation ofCurrent(Setting s, double scale) {
        List<Parameter> linear = new ArrayList<>(Parameter.vector("sine", "m/s", scale));
        linear.addAll(Parameter.vector("cosine", "m/s", scale));
        return new Oscillation(s, "u", "m/s", linear);
    }

    private Oscillation(Setting s, String name, String unit, List<Parameter> linear) {
        this.name = name;
        this.unit = unit;
        frequencies = new Frequencies(s);
        begin = s.path().begin();
        parameters = new ArrayList<>(linear);
        parameters.add(frequencies.parameter());
    }

    List<Parameter> parameters() {
        return parameters;
    }

    /** One for each of some angular frequencies (rad/s). */
    List<Guess> guesses(double[] frequencies) {
        return Arrays.stream(frequencies)
                .mapToObj(omega -> new double[] {0, 0, 0, 0, 0, 0, omega})
                .map(theta -> Change.guess(parameters, theta, 0, 1, 2, 3, 4, 5))
                .toList();
    }

    /** At frequencies that no run by itself tells from that of some numbers. */
    List<Guess> aliases(double[] theta) {
        return guesses(frequencies.aliases(theta[OMEGA]));
    }

    /** What stands before sin(omega t), t being the world's time. */
    Vec3 sine(double[] theta) {
        double phase = theta[OMEGA] * begin;
        return vector(theta, 0)
                .times(StrictMath.cos(phase))
                .plus(vector(theta, 3).times(StrictMath.sin(phase)));
    }

    /** What stands before cos(omega t). */
    Vec3 cosine(double[] theta) {
        double phase = theta[OMEGA] * begin;
        return vector(theta, 3)
                .times(StrictMath.cos(phase))
                .minus(vector(theta, 0).times(StrictMath.sin(phase)));
    }

    private static Vec3 vector(double[] theta, int from) {
        return new Vec3(theta[from], theta[from + 1], theta[from + 2]);
    }

    /** vector sin(omega t + phase), its largest component above 0. */
    List<Quantity> quantities(double[] theta) {
        Vec3 sine = sine(theta);
        Vec3 cosine = cosine(theta);
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
                Quantity.frequency(theta[OMEGA]),
                new Quantity("phase", "rad", phase));
    }

    private static double largest(Vec3 v) {
        double largest = Math.abs(v.y()) > Math.abs(v.x()) ? v.y() : v.x();
        return Math.abs(v.z()) > Math.abs(largest) ? v.z() : largest;
    }
}
