package org.auvsim.core.sensor;

import org.auvsim.core.actuator.Battery;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Need;

import java.util.Optional;

/**
 * Measures what is left in a battery of its object; 0 J is how a battery tells that its propulsors
 * stop.
 *
 * @param battery its name
 * @param errors of the charge
 */
public record BatteryGauge(
        String name,
        String battery,
        @Unit("J") @Default("0.0") ScalarErrors errors,
        Sampling sampling)
        implements Sensor {
    @Override
    public Optional<Need> needs() {
        return Optional.of(Need.named(Battery.class, battery));
    }

    @Override
    public Optional<SensorReading> read(Sample sample) {
        Scene scene = sample.scene();
        double time = sample.now().time();
        return scene.components(Battery.class).stream()
                .filter(cells -> cells.name().equals(battery))
                .findFirst()
                .map(cells -> cells.chargeAt(time, scene.components(Propulsor.class)))
                .map(charge -> new BatteryReading(errors.disturb(charge, sample.noise(), 0)));
    }
}
