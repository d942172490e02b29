package org.auvsim.core.sensor;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.Optional;

/**
 * Measures the pressure of the water above it and tells it as a depth, as if the water's density
 * were the one that it was calibrated for: a depth h reads h * density / calibration density. Above
 * the surface it reads 0, but for its errors.
 *
 * @param position in the body
 * @param surface height of the water's surface
 * @param density of the water
 * @param calibrationDensity that its depths are told for
 * @param errors of the depth
 */
public record DepthSensor(
        String name,
        @Unit("m") @Default("0 0 0") Vec3 position,
        @Unit("m") @Default("0.0") double surface,
        @Unit("kg/m^3") @Default("1025.0") double density,
        @Unit("kg/m^3") @Default("1025.0") double calibrationDensity,
        @Unit("m") @Default("0.0") ScalarErrors errors,
        Sampling sampling)
        implements Sensor {
    /**
     * A checked sensor.
     *
     * @throws IllegalArgumentException if a number is not finite or a density not positive
     */
    public DepthSensor {
        String of = Domain.named("depth-sensor", name);
        Domain.finite(of, "position", position, "m");
        Domain.finite(of, "surface", surface, "m");
        Domain.above0(of, "density", density, "kg/m^3");
        Domain.above0(of, "calibration-density", calibrationDensity, "kg/m^3");
    }

    @Override
    public Optional<SensorReading> read(Sample sample) {
        double height = sample.at(position, Quat.IDENTITY).position().z();
        double depth = Math.max(0, surface - height) * (density / calibrationDensity);
        return Optional.of(new DepthReading(errors.disturb(depth, sample.noise(), 0)));
    }
}
