package org.auvsim.core.sensor;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.Optional;

/**
 * An inertial measurement unit: tells the mean angular rate and the mean specific force (velocity's
 * change without that by gravity) at its place, in its axes, over the time from one reading to the
 * next, as units do that give increments of angle and velocity (Titterton and Weston 2004, section
 * 11.2). What a collision does to the velocity is in them.
 *
 * <p>The rate is that of the one turn that leads from the orientation before to that now, which has
 * to be less than half a turn; the force is seen in the axes halfway.
 *
 * @param position in the body
 * @param orientation its axes to the body's
 * @param gravity that it feels as a force upward, while at rest
 * @param gyroscope errors of the rate
 * @param accelerometer errors of the specific force
 */
public record Imu(
        String name,
        @Unit("m") @Default("0 0 0") Vec3 position,
        @Default("1 0 0 0") Quat orientation,
        @Unit("m/s^2") @Default("9.80665") double gravity,
        @Unit("rad/s") @Default("0 0 0") InertialErrors gyroscope,
        @Unit("m/s^2") @Default("0 0 0") InertialErrors accelerometer,
        Sampling sampling)
        implements Sensor {
    /**
     * A checked sensor.
     *
     * @throws IllegalArgumentException if a number is not finite, or gravity negative
     */
    public Imu {
        String of = Domain.named("imu", name);
        Domain.finite(of, "position", position, "m");
        orientation = Domain.unit(of, "orientation", orientation);
        Domain.atLeast0(of, "gravity", gravity, "m/s^2");
    }

    @Override
    public Optional<SensorReading> read(Sample sample) {
        Kinematics before = sample.before().at(position, orientation);
        Kinematics now = sample.at(position, orientation);
        double time = now.time() - before.time();
        if (!(time > 0)) {
            return Optional.empty();
        }
        Vec3 turn = turn(before.orientation(), now.orientation());
        Vec3 gained = now.velocity().minus(before.velocity()).times(1 / time);
        Vec3 force = gained.plus(new Vec3(0, 0, gravity));
        Vec3 inItsAxes = halfway(before.orientation(), now.orientation()).rotateInverse(force);
        double rate = sampling.rate();
        return Optional.of(
                new ImuReading(
                        gyroscope.at(rate).disturb(turn.times(1 / time), sample.noise(), 0),
                        accelerometer.at(rate).disturb(inItsAxes, sample.noise(), 3)));
    }

    /** The turn (rad, in the turned axes) from one orientation to another. */
    private static Vec3 turn(Quat from, Quat to) {
        Quat d = from.conjugate().times(to);
        Vec3 half = new Vec3(d.x(), d.y(), d.z());
        double sine = half.norm();
        double angle = 2 * StrictMath.atan2(sine, Math.abs(d.w()));
        double scale = sine > 0 ? angle / sine : 2;
        return half.times(d.w() < 0 ? -scale : scale);
    }

    private static Quat halfway(Quat a, Quat b) {
        double sign = a.w() * b.w() + a.x() * b.x() + a.y() * b.y() + a.z() * b.z() < 0 ? -1 : 1;
        return new Quat(
                        a.w() + sign * b.w(),
                        a.x() + sign * b.x(),
                        a.y() + sign * b.y(),
                        a.z() + sign * b.z())
                .normalized();
    }
}
