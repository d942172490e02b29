package org.auvsim.core.sensor;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.entity.MagneticField;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.Optional;

/**
 * Measures the sum of the world's magnetic fields at its place, in its axes.
 *
 * @param position in the body
 * @param orientation its axes to the body's
 * @param fieldErrors of the flux density; its bias is the vehicle's own (hard iron)
 */
public record Magnetometer(
        String name,
        @Unit("m") @Default("0 0 0") Vec3 position,
        @Default("1 0 0 0") Quat orientation,
        @Unit("T") @Default("0 0 0") VectorErrors fieldErrors,
        Sampling sampling)
        implements Sensor {
    /**
     * A checked sensor.
     *
     * @throws IllegalArgumentException if a number is not finite
     */
    public Magnetometer {
        String of = Domain.named("magnetometer", name);
        Domain.finite(of, "position", position, "m");
        orientation = Domain.unit(of, "orientation", orientation);
    }

    @Override
    public Optional<SensorReading> read(Sample sample) {
        Kinematics here = sample.at(position, orientation);
        Vec3 sum = Vec3.ZERO;
        for (MagneticField field : sample.scene().fields(MagneticField.class)) {
            sum = sum.plus(field.valueAt(here.position(), here.time()));
        }
        Vec3 seen = here.orientation().rotateInverse(sum);
        return Optional.of(new MagnetometerReading(fieldErrors.disturb(seen, sample.noise(), 0)));
    }
}
