package org.auvsim.core.sensor;

import org.auvsim.core.description.Default;
import org.auvsim.core.entity.Domain;

/**
 * How a measured number differs from the true one, in its unit: {@code true + bias + drift W(t) +
 * deviation N}, N with normal distribution, W a Wiener process that was 0 at world time 0.
 *
 * @param deviation standard deviation of each reading's own noise
 * @param bias constant
 * @param drift what the bias gains by random walk, as standard deviation after 1 s: it grows with
 *     the root of time
 */
public record ScalarErrors(
        @Default("0.0") double deviation,
        @Default("0.0") double bias,
        @Default("0.0") double drift) {
    /** A sensor without errors. */
    public static final ScalarErrors NONE = new ScalarErrors(0, 0, 0);

    /**
     * Checked errors.
     *
     * @throws IllegalArgumentException if deviation or drift is negative, or a number not finite
     */
    public ScalarErrors {
        Domain.atLeast0("a sensor", "deviation", deviation, "");
        Domain.atLeast0("a sensor", "drift", drift, "");
        Domain.finite("a sensor", "bias", bias, "");
    }

    /** What is measured of a value; each channel of a sensor has its own noise. */
    public double disturb(double value, Noise noise, int channel) {
        double sum = value + bias;
        if (drift > 0) {
            sum += drift * noise.walk(channel);
        }
        return deviation > 0 ? sum + deviation * noise.gaussian(channel) : sum;
    }
}
