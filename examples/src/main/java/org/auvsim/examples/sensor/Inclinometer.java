package org.auvsim.examples.sensor;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.sensor.Noise;
import org.auvsim.core.sensor.Sample;
import org.auvsim.core.sensor.Sampling;
import org.auvsim.core.sensor.ScalarErrors;
import org.auvsim.core.sensor.Sensor;
import org.auvsim.core.sensor.SensorReading;

import java.util.Optional;

/**
 * Tells how a body leans.
 *
 * @param errors of each of the two angles
 */
public record Inclinometer(
        String name, @Unit("rad") @Default("0.0") ScalarErrors errors, Sampling sampling)
        implements Sensor {
    /** The first angle's noise; any two numbers that are not used for something else will do. */
    private static final int ROLL = 0;

    private static final int PITCH = 1;

    @Override
    public Optional<SensorReading> read(Sample sample) {
        Mat3 axes = sample.now().orientation().toMatrix();
        Noise noise = sample.noise();
        double roll = StrictMath.atan2(axes.zy(), axes.zz());
        double pitch = -StrictMath.asin(Math.clamp(axes.zx(), -1, 1));
        return Optional.of(
                new Inclination(
                        errors.disturb(roll, noise, ROLL), errors.disturb(pitch, noise, PITCH)));
    }
}
