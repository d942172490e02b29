package org.auvsim.core.actuator;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Actuator;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Vec3;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A fin, fixed or steered: lift across and drag along the flow at its place, which is that of the
 * water relative to body, turn and all; what flows along the span does nothing. A positive angle
 * turns it about its span by the right-hand rule. {@link Polar} has its coefficients.
 *
 * @param area seen along its normal (m^2), to which the coefficients refer
 * @param liftSlope lift coefficient for each radian of angle of attack (1/rad); a low aspect ratio
 *     makes it much smaller than the 2 pi of a long wing
 * @param position of its centre of pressure (m, body)
 * @param chord forward along it at angle 0 (body axes; any length above 0)
 * @param span about which it turns (body axes); of the chord, what is square to it counts
 * @param dragCoefficient C_D0, without lift
 * @param inducedDrag k in C_D0 + k C_L^2; 1/(pi e AR) at aspect ratio AR and efficiency e
 * @param stallAngle up to which the flow is attached (rad)
 * @param density of the water (kg/m^3)
 * @param race by which the stream of a propeller before it is faster than the water around, along
 *     the chord (m/s); as it is with the propeller at work
 * @param angle as commanded (rad)
 * @param maximumAngle to either side (rad)
 * @param maximumRate with which it turns (rad/s); empty: at once
 * @param reached the angle it had reached at the last command; empty: it has come to rest
 */
public record Fin(
        String name,
        @Unit("m^2") double area,
        @Unit("1/rad") double liftSlope,
        @Unit("m") @Default("0 0 0") Vec3 position,
        @Default("1 0 0") Vec3 chord,
        Vec3 span,
        @Default("0.0") double dragCoefficient,
        @Default("0.0") double inducedDrag,
        @Unit("rad") @Default("0.35") double stallAngle,
        @Unit("kg/m^3") @Default("1025.0") double density,
        @Unit("m/s") @Default("0.0") double race,
        @Unit("rad") @Default("0.0") double angle,
        @Unit("rad") @Default("0.35") double maximumAngle,
        @Unit("rad/s") OptionalDouble maximumRate,
        Optional<Reached> reached)
        implements Actuator {
    /**
     * A checked fin; chord and span are normalised.
     *
     * @throws IllegalArgumentException naming the fin and what is outside its range
     */
    public Fin {
        String of = Domain.named("fin", name);
        Domain.above0(of, "area", area, "m^2");
        Domain.finite(of, "position", position, "m");
        Domain.atLeast0(of, "lift slope", liftSlope, "per rad");
        Domain.atLeast0(of, "drag coefficient", dragCoefficient, "");
        Domain.atLeast0(of, "induced drag factor", inducedDrag, "");
        Domain.require(
                0 < stallAngle && stallAngle <= Math.PI / 2,
                of,
                "stall angle",
                stallAngle,
                "above 0 and at most pi/2 rad",
                "rad");
        Domain.above0(of, "density", density, "kg/m^3");
        Domain.finite(of, "race", race, "m/s");
        Domain.require(
                0 <= maximumAngle && maximumAngle <= Math.PI,
                of,
                "maximum angle",
                maximumAngle,
                "0 to pi rad",
                "rad");
        Domain.within(of, "angle", -maximumAngle, maximumAngle, angle, "rad");
        maximumRate.ifPresent(rate -> Domain.above0(of, "maximum rate", rate, "rad/s"));
        Vec3 along = Domain.unit(of, "chord", chord);
        Vec3 about = Domain.unit(of, "span", span);
        if (!(chord.cross(span).norm() > 0)) {
            throw new IllegalArgumentException(
                    "chord and span of fin '%s' must be across each other, but are %s and %s"
                            .formatted(name, chord, span));
        }
        chord = along;
        span = about;
    }

    @Override
    public double command() {
        return angle;
    }

    /** The same fin on its way to another angle (rad) from a time (s) on. */
    @Override
    public Fin commanded(double angle, double time) {
        return with(
                area,
                chord,
                race,
                angle,
                maximumRate.isEmpty()
                        ? Optional.empty()
                        : Optional.of(new Reached(angleAt(time), time)));
    }

    /** The same with another area (m^2): weaker or stronger by that. */
    public Fin sized(double otherArea) {
        return with(otherArea, chord, race, angle, reached);
    }

    /** The same in a race of another speed (m/s). */
    public Fin inRace(double speed) {
        return with(area, chord, speed, angle, reached);
    }

    /** The same, built in with its chord turned about its span by an angle (rad). */
    public Fin trimmed(double by) {
        Vec3 along = span.times(span.dot(chord) * (1 - StrictMath.cos(by)));
        Vec3 turned =
                chord.times(StrictMath.cos(by))
                        .plus(span.cross(chord).times(StrictMath.sin(by)))
                        .plus(along);
        return with(area, turned, race, angle, reached);
    }

    private Fin with(
            double area, Vec3 chord, double race, double angle, Optional<Reached> reached) {
        return new Fin(
                name,
                area,
                liftSlope,
                position,
                chord,
                span,
                dragCoefficient,
                inducedDrag,
                stallAngle,
                density,
                race,
                angle,
                maximumAngle,
                maximumRate,
                reached);
    }

    /** Its angle (rad) at a time (s): with its maximum rate towards the commanded one. */
    public double angleAt(double time) {
        if (reached.isEmpty() || maximumRate.isEmpty()) {
            return angle;
        }
        double way = angle - reached.get().value();
        double most = maximumRate.getAsDouble() * Math.max(time - reached.get().at(), 0);
        return Math.abs(way) <= most ? angle : reached.get().value() + Math.copySign(most, way);
    }

    @Override
    public void add(Block b, int i) {
        double px = position.x();
        double py = position.y();
        double pz = position.z();
        double wx = b.vx[i] - b.ux[i];
        double wy = b.vy[i] - b.uy[i];
        double wz = b.vz[i] - b.uz[i];
        double vx = b.rxx[i] * wx + b.ryx[i] * wy + b.rzx[i] * wz + b.bodyWy[i] * pz;
        double vy = b.rxy[i] * wx + b.ryy[i] * wy + b.rzy[i] * wz + b.bodyWz[i] * px;
        double vz = b.rxz[i] * wx + b.ryz[i] * wy + b.rzz[i] * wz + b.bodyWx[i] * py;
        vx -= b.bodyWz[i] * py;
        vy -= b.bodyWx[i] * pz;
        vz -= b.bodyWy[i] * px;
        vx += race * chord.x();
        vy += race * chord.y();
        vz += race * chord.z();
        double sx = span.x();
        double sy = span.y();
        double sz = span.z();
        double along = vx * sx + vy * sy + vz * sz;
        vx -= along * sx;
        vy -= along * sy;
        vz -= along * sz;
        double speed = Math.sqrt(vx * vx + vy * vy + vz * vz);
        if (speed == 0) {
            return;
        }
        // The direction of lift, square to flow and span: s x v, as long as v.
        double nx = sy * vz - sz * vy;
        double ny = sz * vx - sx * vz;
        double nz = sx * vy - sy * vx;
        double ahead = vx * chord.x() + vy * chord.y() + vz * chord.z();
        double aside = nx * chord.x() + ny * chord.y() + nz * chord.z();
        double attack = Polar.wrapped(Polar.angle(aside, ahead) + angleAt(b.time));
        double pressure = 0.5 * density * area * speed;
        double lift = pressure * Polar.lift(this, attack);
        double drag = pressure * Polar.drag(this, attack);
        double fx = lift * nx - drag * vx;
        double fy = lift * ny - drag * vy;
        double fz = lift * nz - drag * vz;
        b.addFromBody(i, fx, fy, fz, py * fz - pz * fy, pz * fx - px * fz, px * fy - py * fx);
    }
}
