package org.auvsim.core.sensor;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.Optional;

/**
 * A compass that is kept level: tells where its x axis points, seen from above, as mariners do:
 * clockwise from north, which is the world's y axis. What stands on end has no heading.
 *
 * @param orientation its axes to the body's
 * @param declination of magnetic north from true north, positive to the east; the compass tells
 *     headings from magnetic north
 * @param errors of the heading
 */
public record Compass(
        String name,
        @Default("1 0 0 0") Quat orientation,
        @Unit("rad") @Default("0.0") double declination,
        @Unit("rad") @Default("0.0") ScalarErrors errors,
        Sampling sampling)
        implements Sensor {
    private static final double TURN = 2 * Math.PI;

    /**
     * A checked sensor.
     *
     * @throws IllegalArgumentException if a number is not finite
     */
    public Compass {
        String of = Domain.named("compass", name);
        orientation = Domain.unit(of, "orientation", orientation);
        Domain.finite(of, "declination", declination, "rad");
    }

    @Override
    public Optional<SensorReading> read(Sample sample) {
        Vec3 ahead = sample.at(Vec3.ZERO, orientation).orientation().rotate(new Vec3(1, 0, 0));
        if (ahead.x() == 0 && ahead.y() == 0) {
            return Optional.empty();
        }
        double heading = StrictMath.atan2(ahead.x(), ahead.y()) - declination;
        return Optional.of(new CompassReading(wrapped(errors.disturb(heading, sample.noise(), 0))));
    }

    private static double wrapped(double angle) {
        double turned = angle - TURN * Math.floor(angle / TURN);
        return turned < TURN ? turned : 0;
    }
}
