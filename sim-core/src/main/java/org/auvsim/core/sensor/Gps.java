package org.auvsim.core.sensor;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.Optional;

/**
 * A satellite receiver: tells where its antenna is on Earth, as long as that is not too deep below
 * the water's surface, waves and all. The world needs a {@link Datum}.
 *
 * @param position of its antenna in the body
 * @param surface height of the still water's surface
 * @param maximumDepth of the antenna at which it still receives
 * @param positionErrors to the east, to the north and up
 */
public record Gps(
        String name,
        @Unit("m") @Default("0 0 0") Vec3 position,
        @Unit("m") @Default("0.0") double surface,
        @Unit("m") @Default("0.0") double maximumDepth,
        @Unit("m") @Default("0 0 0") VectorErrors positionErrors,
        Sampling sampling)
        implements Sensor {
    /**
     * A checked sensor.
     *
     * @throws IllegalArgumentException if a number is not finite, or the depth negative
     */
    public Gps {
        String of = Domain.named("gps", name);
        Domain.finite(of, "position", position, "m");
        Domain.finite(of, "surface", surface, "m");
        Domain.atLeast0(of, "maximum-depth", maximumDepth, "m");
    }

    @Override
    public Optional<String> lacks(Optional<Datum> datum) {
        return datum.isPresent()
                ? Optional.empty()
                : Optional.of("is a GPS, which needs a datum; add <datum latitude longitude/>");
    }

    @Override
    public Optional<SensorReading> read(Sample sample) {
        Vec3 antenna = sample.at(position, Quat.IDENTITY).position();
        if (Water.depth(sample, antenna, surface) > maximumDepth) {
            return Optional.empty();
        }
        Vec3 measured = positionErrors.disturb(antenna, sample.noise(), 0);
        return sample.scene()
                .datum()
                .map(datum -> datum.toGeodetic(measured))
                .map(at -> new GpsReading(at.latitude(), at.longitude(), at.altitude()));
    }
}
