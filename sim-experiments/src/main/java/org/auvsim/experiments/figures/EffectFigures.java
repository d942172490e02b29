package org.auvsim.experiments.figures;

import org.auvsim.core.effect.Brake;
import org.auvsim.core.effect.Buoyancy;
import org.auvsim.core.effect.CentralForce;
import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.Derivative;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.effect.HydrodynamicDerivatives;
import org.auvsim.core.effect.MagneticDipole;
import org.auvsim.core.effect.MagnusForce;
import org.auvsim.core.effect.Mooring;
import org.auvsim.core.effect.PivotFriction;
import org.auvsim.core.effect.ReferenceAxes;
import org.auvsim.core.effect.Tether;
import org.auvsim.core.entity.AddedMass;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.Pinned;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.UniformMagneticField;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.HalfSpace;
import org.auvsim.core.volume.Sphere;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** A figure for each effect. */
final class EffectFigures {
    private static final String TIME = "time (s)";
    private static final Vec3 NONE = Vec3.ZERO;

    private EffectFigures() {}

    static List<Figure> all() {
        return List.of(
                gravity(),
                buoyancy(),
                damping(),
                addedMass(),
                derivatives(),
                magnus(),
                pivotFriction(),
                brake(),
                contactFriction(),
                mooring(),
                tether(),
                centralForce(),
                magneticDipole());
    }

    private static Figure gravity() {
        return new Figure(
                "gravity",
                "A ball thrown up at 5 m/s, and one that water slows down",
                TIME,
                "height (m)",
                List.of(
                        Trial.of(Trial.ball(new Gravity(9.80665)).velocity(0, 0, 5))
                                .lasting(1.2)
                                .overTime("gravity alone", b -> b.position().z()),
                        Trial.of(Trial.ball(new Gravity(9.80665), linear(20)).velocity(0, 0, 5))
                                .lasting(1.2)
                                .overTime("with damping", b -> b.position().z())));
    }

    private static Damping linear(double k) {
        return new Damping(new Vec3(k, k, k), NONE, NONE, NONE);
    }

    /** A box of 1 x 1 x 0.5 m, half as heavy as its water. */
    private static Figure buoyancy() {
        Buoyancy water = new Buoyancy(0.5, 1000, 9.80665, NONE, 0, OptionalDouble.of(0.5));
        WorldObjectDefinition.Builder box =
                Trial.body()
                        .volume(new Box(new Vec3(1, 1, 0.5)))
                        .mass(250)
                        .position(0, 0, -2)
                        .effect(new Gravity(9.80665))
                        .effect(water)
                        .effect(linear(250));
        return new Figure(
                "buoyancy",
                "A box half as heavy as water comes up from 2 m and floats",
                TIME,
                "height of its centre (m)",
                List.of(Trial.of(box).lasting(12).overTime("box", b -> b.position().z())));
    }

    private static Figure damping() {
        return new Figure(
                "damping",
                "A body of 10 kg that coasts from 2 m/s",
                TIME,
                "speed (m/s)",
                List.of(
                        coasting("linear: 5 N s/m", new Damping(ahead(5), NONE, NONE, NONE)),
                        coasting("quadratic: 5 N s^2/m^2", new Damping(NONE, ahead(5), NONE, NONE)),
                        coasting("both", new Damping(ahead(5), ahead(5), NONE, NONE))));
    }

    private static Vec3 ahead(double k) {
        return new Vec3(k, 0, 0);
    }

    private static Series coasting(String name, Damping damping) {
        return Trial.of(Trial.ball(damping).velocity(2, 0, 0))
                .overTime(name, b -> b.velocity().x());
    }

    private static Figure addedMass() {
        AddedMass added = new AddedMass(new Vec3(1, 20, 20), new Vec3(0, 1, 1), List.of());
        return new Figure(
                "added-mass",
                "A slender body of 10 kg, thrown 10 degrees beside its axis: Munk's torque turns"
                        + " it",
                TIME,
                "yaw rate (rad/s)",
                List.of(
                        Trial.of(thrown(linear(1)).addedMass(added))
                                .lasting(20)
                                .overTime("with added mass", EffectFigures::yawRate),
                        Trial.of(thrown(linear(1)))
                                .lasting(20)
                                .overTime("without", EffectFigures::yawRate)));
    }

    private static WorldObjectDefinition.Builder thrown(Damping damping) {
        return Trial.ball(damping).inertia(new Inertia(0.1, 1, 1, 0, 0, 0)).velocity(1, 0.17, 0);
    }

    private static double yawRate(WorldObject body) {
        return body.angularVelocity().z();
    }

    private static Figure derivatives() {
        List<Derivative> drag =
                List.of(
                        new Derivative("Xu|u|", -0.5),
                        new Derivative("Yv|v|", -130),
                        new Derivative("Nr|r|", -9));
        List<Derivative> lift =
                List.of(
                        new Derivative("Xu|u|", -0.5),
                        new Derivative("Yv|v|", -130),
                        new Derivative("Nr|r|", -9),
                        new Derivative("Yuv", -28.6),
                        new Derivative("Nuv", 4));
        return new Figure(
                "hydrodynamic-derivatives",
                "A torpedo thrown 10 degrees beside its axis, from above",
                "x (m)",
                "y (m)",
                List.of(torpedo("drag alone", drag), torpedo("with body lift and fins", lift)));
    }

    private static Series torpedo(String name, List<Derivative> derivatives) {
        WorldObjectDefinition.Builder torpedo =
                Trial.ball(new HydrodynamicDerivatives(ReferenceAxes.FLU, derivatives))
                        .mass(30)
                        .inertia(new Inertia(0.2, 3.5, 3.5, 0, 0, 0))
                        .velocity(1.5, 0.26, 0);
        return Trial.of(torpedo).path(name);
    }

    private static Figure magnus() {
        return new Figure(
                "magnus-force",
                "Balls that spin about the vertical at 4 rad/s one way and the other, from above",
                "x (m)",
                "y (m)",
                List.of(spinning("4 rad/s", 4), spinning("no spin", 0), spinning("-4 rad/s", -4)));
    }

    private static Series spinning(String name, double rate) {
        return Trial.of(
                        Trial.ball(new MagnusForce(1), linear(2))
                                .velocity(2, 0, 0)
                                .angularVelocity(0, 0, rate))
                .path(name);
    }

    private static Figure pivotFriction() {
        return new Figure(
                "pivot-friction",
                "A flywheel of 2 kg m^2 on its pivot",
                TIME,
                "rate (rad/s)",
                List.of(
                        flywheel("Coulomb: 1.5 N m", new PivotFriction(1.5, 0, 0.02)),
                        flywheel("viscous: 0.8 N m s", new PivotFriction(0, 0.8, 0.02)),
                        flywheel("both", new PivotFriction(1.5, 0.8, 0.02))));
    }

    private static Series flywheel(String name, PivotFriction friction) {
        WorldObjectDefinition.Builder wheel =
                Trial.ball(friction)
                        .inertia(new Inertia(1, 1, 2, 0, 0, 0))
                        .mount(new Pinned(Optional.of(new Vec3(0, 0, 1))))
                        .angularVelocity(0, 0, 5);
        return Trial.of(wheel).lasting(8).overTime(name, EffectFigures::yawRate);
    }

    private static Figure brake() {
        return new Figure(
                "brake",
                "A ball of 10 kg that brakes from 2 m/s",
                TIME,
                "speed (m/s)",
                List.of(
                        braking("10 N", new Brake(10, Vec3.ZERO, 0.05, 0.05)),
                        braking("5 N", new Brake(5, Vec3.ZERO, 0.05, 0.05)),
                        braking("5 N, slip speed 1 m/s", new Brake(5, Vec3.ZERO, 1, 0.05))));
    }

    private static Series braking(String name, Brake brake) {
        return Trial.of(Trial.ball(brake).velocity(2, 0, 0))
                .lasting(6)
                .overTime(name, body -> body.velocity().norm());
    }

    private static Figure mooring() {
        return new Figure(
                "mooring",
                "A buoy that runs out its line of 3 m and is pulled back",
                TIME,
                "distance (m)",
                List.of(moored("no damping", 0), moored("25 N s/m", 25)));
    }

    private static Series moored(String name, double damping) {
        return Trial.of(
                        Trial.ball(new Mooring(NONE, NONE, 3, 40, damping), linear(1))
                                .velocity(1, 0, 0))
                .lasting(15)
                .overTime(name, b -> b.position().norm());
    }

    private static Figure tether() {
        return new Figure(
                "tether",
                "A tug of 10 kg that 10 N drive picks up a barge of 20 kg on a line of 2 m",
                TIME,
                "speed of the tug (m/s)",
                List.of(towed("no damping", 0), towed("25 N s/m", 25)));
    }

    private static Series towed(String name, double damping) {
        WorldObjectDefinition barge =
                WorldObjectDefinition.named("barge")
                        .id(7)
                        .volume(new Sphere(0.3))
                        .mass(20)
                        .position(-1, 0, 0)
                        .effect(linear(10))
                        .build();
        return Trial.of(
                        Trial.ball(new Tether(7, NONE, NONE, 2, 60, damping), linear(5))
                                .force(new NamedForce("drive", Frame.WORLD, ahead(10), NONE)))
                .with(barge)
                .lasting(20)
                .overTime(name, tug -> tug.velocity().x());
    }

    private static Figure contactFriction() {
        return new Figure(
                "contact-friction",
                "A box that slides on the floor from 3 m/s until it sticks",
                TIME,
                "speed (m/s)",
                List.of(
                        sliding("friction 0.5", 0.5),
                        sliding("friction 0.2", 0.2),
                        Series.of("v - 0.2 g t", 0, 2, t -> Math.max(0, 3 - 0.2 * 9.80665 * t))));
    }

    private static Series sliding(String name, double friction) {
        WorldObjectDefinition floor =
                WorldObjectDefinition.named("floor")
                        .volume(new HalfSpace())
                        .fixed()
                        .friction(friction)
                        .build();
        WorldObjectDefinition.Builder box =
                Trial.body()
                        .volume(new Box(new Vec3(1, 1, 0.4)))
                        .mass(10)
                        .position(0, 0, 0.2)
                        .velocity(3, 0, 0)
                        .restitution(0)
                        .friction(friction)
                        .effect(new Gravity(9.80665));
        return Trial.of(box).with(floor).lasting(2).overTime(name, b -> b.velocity().norm());
    }

    private static Figure centralForce() {
        return new Figure(
                "central-force",
                "A body that 4 N pull to the world's origin, from above",
                "x (m)",
                "y (m)",
                List.of(
                        Trial.of(
                                        Trial.ball(new CentralForce(4, 0.1, NONE), linear(0.5))
                                                .position(3, 0, 0)
                                                .velocity(0, 0.8, 0))
                                .lasting(40)
                                .path("body")));
    }

    private static Figure magneticDipole() {
        WorldObjectDefinition.Builder needle =
                Trial.ball(
                                new MagneticDipole(new Vec3(2e4, 0, 0)),
                                new Damping(NONE, NONE, new Vec3(0.3, 0.3, 0.3), NONE))
                        .angularVelocity(0, 0, 0.4);
        return new Figure(
                "magnetic-dipole",
                "A magnet of 20,000 A m^2 turns to a field of 50 microtesla along y",
                TIME,
                "heading (degrees from x)",
                List.of(
                        Trial.of(needle)
                                .in(new UniformMagneticField(2, "earth", new Vec3(0, 5e-5, 0)))
                                .lasting(40)
                                .overTime("magnet", EffectFigures::heading)));
    }

    private static double heading(WorldObject body) {
        Vec3 ahead = body.orientation().rotate(new Vec3(1, 0, 0));
        return StrictMath.toDegrees(StrictMath.atan2(ahead.y(), ahead.x()));
    }
}
