package org.auvsim.core.sensor;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A Doppler velocity log with four beams that lean out of its -z axis, two ahead and two astern
 * (Janus): tells its velocity in its axes, against the bottom if three beams or more reach
 * something fixed within the range, else against the water at its place.
 *
 * @param position in the body
 * @param orientation its axes to the body's
 * @param beamAngle between a beam and the -z axis
 * @param range of a beam
 * @param scale that velocities are multiplied by: 1 and what speed of sound and alignment are wrong
 *     by
 * @param velocityErrors of the velocity
 * @param altitudeErrors of the altitude
 */
public record Dvl(
        String name,
        @Unit("m") @Default("0 0 0") Vec3 position,
        @Default("1 0 0 0") Quat orientation,
        @Unit("rad") @Default("0.5235987755982988") double beamAngle,
        @Unit("m") double range,
        @Default("1.0") double scale,
        @Unit("m/s") @Default("0 0 0") VectorErrors velocityErrors,
        @Unit("m") @Default("0.0") ScalarErrors altitudeErrors,
        Sampling sampling)
        implements Sensor {
    private static final int BEAMS = 4;
    private static final int FEWEST = 3;
    private static final double STEEPEST = 1.5;

    /**
     * A checked sensor.
     *
     * @throws IllegalArgumentException if a number is not finite, the beam angle outside [0, 1.5],
     *     or range or scale not positive
     */
    public Dvl {
        String of = Domain.named("dvl", name);
        Domain.finite(of, "position", position, "m");
        orientation = Domain.unit(of, "orientation", orientation);
        Domain.within(of, "beam-angle", 0, STEEPEST, beamAngle, "rad");
        Domain.above0(of, "range", range, "m");
        Domain.above0(of, "scale", scale, "");
    }

    @Override
    public boolean looksAround() {
        return true;
    }

    @Override
    public Optional<SensorReading> read(Sample sample) {
        Kinematics here = sample.at(position, orientation);
        OptionalDouble altitude = altitude(sample.scene(), here);
        Vec3 velocity =
                altitude.isPresent()
                        ? here.velocity()
                        : here.velocity().minus(Water.velocity(sample, here.position()));
        Vec3 seen = here.orientation().rotateInverse(velocity).times(scale);
        return Optional.of(
                new DvlReading(
                        velocityErrors.disturb(seen, sample.noise(), 0),
                        altitude.isPresent() ? DvlReference.BOTTOM : DvlReference.WATER,
                        altitude.isPresent()
                                ? OptionalDouble.of(
                                        altitudeErrors.disturb(
                                                altitude.getAsDouble(), sample.noise(), 3))
                                : altitude));
    }

    /** The mean of what the beams reach along the axis; empty if too few reach something. */
    private OptionalDouble altitude(Scene scene, Kinematics here) {
        double sum = 0;
        int reached = 0;
        double ahead = StrictMath.sin(beamAngle) * Math.sqrt(0.5);
        double down = StrictMath.cos(beamAngle);
        for (int beam = 0; beam < BEAMS; beam++) {
            Vec3 leaning =
                    new Vec3(beam < 2 ? ahead : -ahead, beam % 2 == 0 ? ahead : -ahead, -down);
            Optional<Scene.Sighting> seen =
                    scene.look(
                            here.position(),
                            here.orientation().rotate(leaning),
                            range,
                            Scene.Target.FIXED_BODY);
            if (seen.isPresent()) {
                sum += seen.get().distance() * down;
                reached++;
            }
        }
        return reached < FEWEST ? OptionalDouble.empty() : OptionalDouble.of(sum / reached);
    }
}
