package org.auvsim.core.sensor;

import org.auvsim.core.description.Default;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Vec3;

/**
 * The errors of a gyroscope (rad/s) or an accelerometer (m/s^2), axis by axis, as datasheets and
 * Allan variances state them (IEEE Std 952-1997, annex C): with noise density N and rate random
 * walk K the Allan variance over a time tau is N^2 / tau + K^2 tau / 3.
 *
 * @param noiseDensity N of the white noise, in the unit per root of Hz (angle or velocity random
 *     walk)
 * @param bias constant
 * @param drift K of the bias' random walk, in the unit per root of s
 */
public record InertialErrors(
        @Default("0 0 0") Vec3 noiseDensity,
        @Default("0 0 0") Vec3 bias,
        @Default("0 0 0") Vec3 drift) {
    /** A sensor without errors. */
    public static final InertialErrors NONE = new InertialErrors(Vec3.ZERO, Vec3.ZERO, Vec3.ZERO);

    /**
     * Checked errors.
     *
     * @throws IllegalArgumentException if a density or drift is negative, or a number not finite
     */
    public InertialErrors {
        VectorErrors.requireSpread("noise-density", noiseDensity);
        VectorErrors.requireSpread("drift", drift);
        Domain.finite("a sensor", "bias", bias, "");
    }

    /** The errors of means over 1 / rate (s). */
    VectorErrors at(double rate) {
        return new VectorErrors(noiseDensity.times(Math.sqrt(rate)), bias, drift);
    }
}
