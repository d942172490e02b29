package org.auvsim.experiments.vehicle;

import org.auvsim.core.actuator.Fin;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.Actuator;
import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.Mount;
import org.auvsim.core.entity.Twist;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.entity.Wrench;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;

import java.util.Optional;
import java.util.function.ToDoubleFunction;

/**
 * Still, deep water in which a vehicle is tried, its fins amidships, without its behaviors and what
 * ties it to places and other bodies.
 */
final class TestTank {
    private static final double DEEP = -1000;
    private static final double INSTANT = 1e-6;

    /** Before the beginning: what was commanded then has been reached. */
    private static final double LONG_AGO = -1e6;

    private TestTank() {}

    /** A world with the vehicle alone, at rest, its propulsors at levels of choice. */
    static World with(
            WorldObjectDefinition vehicle,
            Optional<Mount> mount,
            double timeStep,
            ToDoubleFunction<Propulsor> levels) {
        WorldObjectDefinition.Builder body =
                WorldObjectDefinition.named(vehicle.name())
                        .mass(vehicle.mass().orElseThrow())
                        .volume(vehicle.volume())
                        .position(0, 0, DEEP);
        vehicle.inertia().ifPresent(body::inertia);
        vehicle.centreOfMass().ifPresent(body::centreOfMass);
        vehicle.addedMass().ifPresent(body::addedMass);
        mount.ifPresent(body::mount);
        vehicle.effect().stream().filter(effect -> !effect.dependsOnPlace()).forEach(body::effect);
        for (Component component : vehicle.component()) {
            actuator(component, levels).ifPresent(body::component);
        }
        return World.builder().timeStep(timeStep).add(body.build()).build();
    }

    private static Optional<Actuator> actuator(
            Component component, ToDoubleFunction<Propulsor> levels) {
        return switch (component) {
            case Propulsor p -> Optional.of(settled(p, levels.applyAsDouble(p)));
            case Fin fin -> Optional.of(fin.commanded(0, LONG_AGO));
            default -> Optional.empty();
        };
    }

    private static Propulsor settled(Propulsor p, double level) {
        return new Propulsor(
                p.name(),
                p.maximumThrust(),
                level,
                p.position(),
                p.direction(),
                p.thrustCurve(),
                p.lag(),
                p.deadZone(),
                p.reactionTorque(),
                p.advanceLoss(),
                p.rotor(),
                Optional.empty(),
                p.condition(),
                Optional.empty());
    }

    /** Force and torque of the water (body axes, about the origin) on it while it moves so. */
    static Wrench water(WorldObjectDefinition vehicle, Twist motion) {
        Wrench moving = rates(vehicle, motion);
        Wrench resting = rates(vehicle, new Twist(Vec3.ZERO, Vec3.ZERO));
        return new Wrench(
                moving.force().minus(resting.force()), moving.torque().minus(resting.torque()));
    }

    private static Wrench rates(WorldObjectDefinition vehicle, Twist motion) {
        World world = with(vehicle, Optional.empty(), INSTANT, _ -> 0);
        WorldObject body = moving(world, Quat.IDENTITY, motion);
        Vec3 momentum = body.linearMomentum();
        Vec3 angularMomentum = body.angularMomentum();
        world.advanceTimestep();
        // dL/dt = torque - v x P: what momenta carried along do is no force of the water.
        return new Wrench(
                body.linearMomentum().minus(momentum).times(1 / INSTANT),
                body.angularMomentum()
                        .minus(angularMomentum)
                        .times(1 / INSTANT)
                        .plus(motion.velocity().cross(momentum)));
    }

    /** By how much velocity and angular velocity in its own axes change (per s). */
    static Twist accelerations(WorldObjectDefinition vehicle, Quat attitude, Twist motion) {
        World world = with(vehicle, Optional.empty(), INSTANT, _ -> 0);
        WorldObject body = moving(world, attitude, motion);
        world.advanceTimestep();
        Quat after = body.orientation();
        return new Twist(
                rate(after.rotateInverse(body.velocity()), motion.velocity()),
                rate(after.rotateInverse(body.angularVelocity()), motion.angularVelocity()));
    }

    private static WorldObject moving(World world, Quat attitude, Twist motion) {
        WorldObject body = world.objects().getFirst();
        body.setOrientation(attitude);
        body.setVelocity(attitude.rotate(motion.velocity()));
        body.setAngularVelocity(attitude.rotate(motion.angularVelocity()));
        return body;
    }

    private static Vec3 rate(Vec3 after, Vec3 before) {
        return after.minus(before).times(1 / INSTANT);
    }
}
