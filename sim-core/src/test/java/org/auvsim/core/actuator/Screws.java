package org.auvsim.core.actuator;

import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;

import java.util.List;
import java.util.Optional;

/** Propulsors for tests, and a world with one body that has them. */
final class Screws {
    static final double THRUST = 12;
    static final double LAG = 0.4;
    static final double MASS = 5;

    private Screws() {}

    static Propulsor plain(double level) {
        return new Propulsor("screw", THRUST, level, Vec3.ZERO, new Vec3(1, 0, 0));
    }

    static Propulsor lagging(double level, double deadZone, Optional<ThrustCurve> curve) {
        return new Propulsor(
                "screw",
                THRUST,
                level,
                Vec3.ZERO,
                new Vec3(1, 0, 0),
                curve,
                LAG,
                deadZone,
                0,
                0,
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty());
    }

    static Propulsor drawing(double level, double watts) {
        return new Propulsor(
                "screw",
                THRUST,
                level,
                Vec3.ZERO,
                new Vec3(1, 0, 0),
                Optional.empty(),
                LAG,
                0,
                0,
                0,
                Optional.empty(),
                Optional.of(new PowerDraw("cells", watts, 0, true)),
                Optional.empty(),
                Optional.empty());
    }

    static World world(Component... components) {
        WorldObjectDefinition.Builder body =
                WorldObjectDefinition.named("body").mass(MASS).volume(new Sphere(0.2));
        List.of(components).forEach(body::component);
        return World.builder().timeStep(0.05).add(body.build()).build();
    }

    static WorldObject body(World world) {
        return world.object("body");
    }

    static Propulsor screw(World world) {
        return body(world).component(Propulsor.class, "screw").orElseThrow();
    }

    static void advance(World world, int steps) {
        for (int i = 0; i < steps; i++) {
            world.advanceTimestep();
        }
    }
}
