package org.auvsim.core.sensor;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A sonar with one thin beam along its x axis, or with a fan of them in its x-y plane: tells how
 * far the nearest body is on each. Beams are straight and echo from any surface at any angle.
 *
 * @param position in the body
 * @param orientation its axes to the body's
 * @param beams how many, 1 to 512; they are numbered from starboard (-y) to port, from 0 on
 * @param fan angle between the first and the last beam, less than half a turn
 * @param minimumRange below which it hears no echo
 * @param maximumRange above which it hears none
 * @param errors of the distances
 */
public record RangeSonar(
        String name,
        @Unit("m") @Default("0 0 0") Vec3 position,
        @Default("1 0 0 0") Quat orientation,
        @Default("1") int beams,
        @Unit("rad") @Default("0.0") double fan,
        @Unit("m") @Default("0.0") double minimumRange,
        @Unit("m") double maximumRange,
        @Unit("m") @Default("0.0") ScalarErrors errors,
        Sampling sampling)
        implements Sensor {
    private static final int MOST_BEAMS = 512;

    /**
     * A checked sensor.
     *
     * @throws IllegalArgumentException if a number is not finite or outside of what is said above
     */
    public RangeSonar {
        String of = Domain.named("range-sonar", name);
        Domain.finite(of, "position", position, "m");
        orientation = Domain.unit(of, "orientation", orientation);
        Domain.within(of, "beams", 1, MOST_BEAMS, beams, "");
        Domain.require(0 <= fan && fan < Math.PI, of, "fan", fan, "0 to below pi rad", "rad");
        Domain.above0(of, "maximum-range", maximumRange, "m");
        Domain.within(of, "minimum-range", 0, maximumRange, minimumRange, "m");
    }

    @Override
    public boolean looksAround() {
        return true;
    }

    @Override
    public Optional<SensorReading> read(Sample sample) {
        Kinematics here = sample.at(position, orientation);
        List<RangeReading.Echo> echoes = new ArrayList<>();
        for (int beam = 0; beam < beams; beam++) {
            Optional<Scene.Sighting> seen =
                    sample.scene()
                            .look(
                                    here.position(),
                                    here.orientation().rotate(direction(beam)),
                                    maximumRange,
                                    Scene.Target.ANY_BODY);
            if (seen.isPresent() && seen.get().distance() >= minimumRange) {
                double distance = seen.get().distance();
                echoes.add(
                        new RangeReading.Echo(
                                beam, errors.disturb(distance, sample.noise(), beam)));
            }
        }
        return Optional.of(new RangeReading(echoes));
    }

    private Vec3 direction(int beam) {
        double angle = beams == 1 ? 0 : fan * ((double) beam / (beams - 1) - 0.5);
        return new Vec3(StrictMath.cos(angle), StrictMath.sin(angle), 0);
    }
}
