package org.auvsim.core.sensor;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.entity.TemperatureField;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.List;
import java.util.Optional;

/**
 * Measures the sum of the world's temperature fields at its place; where there is none, it reads
 * nothing.
 *
 * @param position in the body
 * @param errors of the temperature
 */
public record Thermometer(
        String name,
        @Unit("m") @Default("0 0 0") Vec3 position,
        @Unit("degC") @Default("0.0") ScalarErrors errors,
        Sampling sampling)
        implements Sensor {
    /**
     * A checked sensor.
     *
     * @throws IllegalArgumentException if a number is not finite
     */
    public Thermometer {
        String of = Domain.named("thermometer", name);
        Domain.finite(of, "position", position, "m");
    }

    @Override
    public Optional<SensorReading> read(Sample sample) {
        List<TemperatureField> fields = sample.scene().fields(TemperatureField.class);
        if (fields.isEmpty()) {
            return Optional.empty();
        }
        Kinematics here = sample.at(position, Quat.IDENTITY);
        double sum = 0;
        for (TemperatureField field : fields) {
            sum += field.valueAt(here.position(), here.time());
        }
        return Optional.of(new ThermometerReading(errors.disturb(sum, sample.noise(), 0)));
    }
}
