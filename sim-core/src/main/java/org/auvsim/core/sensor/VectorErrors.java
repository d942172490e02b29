package org.auvsim.core.sensor;

import org.auvsim.core.description.Default;
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
        requireBias(bias);
    }

    static void requireBias(Vec3 bias) {
        if (!bias.isFinite()) {
            throw new IllegalArgumentException(
                    "the bias of a sensor must be finite, but is " + bias);
        }
    }

    static void requireSpread(String what, Vec3 spread) {
        requireSpread(what + " along x", spread.x());
        requireSpread(what + " along y", spread.y());
        requireSpread(what + " along z", spread.z());
    }

    static void requireSpread(String what, double spread) {
        if (!(spread >= 0) || Double.isInfinite(spread)) {
            throw new IllegalArgumentException(
                    "the %s of a sensor must be 0 or more and finite, but is %s"
                            .formatted(what, spread));
        }
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
