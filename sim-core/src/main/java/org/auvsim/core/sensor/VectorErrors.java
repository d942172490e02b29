package org.auvsim.core.sensor;

import org.auvsim.core.description.Default;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Vec3;

/**
 * {@link ScalarErrors} of the three components of a vector, axis by axis.
 *
 * @param deviation standard deviations of each reading's own noise
 * @param bias constant
 * @param drift what the bias gains by random walk, as standard deviations after 1 s
 */
public record VectorErrors(
        @Default("0 0 0") Vec3 deviation,
        @Default("0 0 0") Vec3 bias,
        @Default("0 0 0") Vec3 drift) {
    /** A sensor without errors. */
    public static final VectorErrors NONE = new VectorErrors(Vec3.ZERO, Vec3.ZERO, Vec3.ZERO);

    /**
     * Checked errors.
     *
     * @throws IllegalArgumentException if a deviation or drift is negative, or a number not finite
     */
    public VectorErrors {
        requireSpread("deviation", deviation);
        requireSpread("drift", drift);
        Domain.finite("a sensor", "bias", bias, "");
    }

    static void requireSpread(String what, Vec3 spread) {
        Domain.atLeast0("a sensor", what + " along x", spread.x(), "");
        Domain.atLeast0("a sensor", what + " along y", spread.y(), "");
        Domain.atLeast0("a sensor", what + " along z", spread.z(), "");
    }

    /** What is measured of a value; takes three channels from one on. */
    public Vec3 disturb(Vec3 value, Noise noise, int channel) {
        return new Vec3(
                along(deviation.x(), bias.x(), drift.x()).disturb(value.x(), noise, channel),
                along(deviation.y(), bias.y(), drift.y()).disturb(value.y(), noise, channel + 1),
                along(deviation.z(), bias.z(), drift.z()).disturb(value.z(), noise, channel + 2));
    }

    private static ScalarErrors along(double deviation, double bias, double drift) {
        return new ScalarErrors(deviation, bias, drift);
    }
}
