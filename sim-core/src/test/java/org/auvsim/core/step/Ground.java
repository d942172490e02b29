package org.auvsim.core.step;

import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.HalfSpace;
import org.auvsim.core.volume.Volume;
import org.auvsim.core.world.World;

import java.util.List;

/** Heavy bodies on fixed ground, for tests of contacts that last. */
final class Ground {
    static final double G = 9.81;

    private Ground() {}

    /** A plane through a point with this normal; solid below. */
    static WorldObjectDefinition plane(String name, Vec3 point, Vec3 normal, double friction) {
        return WorldObjectDefinition.named(name)
                .volume(new HalfSpace())
                .fixed()
                .friction(friction)
                .position(point)
                .orientation(turnFromZ(normal.normalized()))
                .build();
    }

    /** The shortest turn that brings the z axis to a unit vector, not straight down. */
    static Quat turnFromZ(Vec3 to) {
        return new Quat(1 + to.z(), -to.y(), to.x(), 0).normalized();
    }

    static WorldObjectDefinition floor(double friction) {
        return plane("Floor", Vec3.ZERO, new Vec3(0, 0, 1), friction);
    }

    /** The floor and four walls of a square room, this wide (m), about the origin. */
    static List<WorldObjectDefinition> room(double wide, double friction) {
        double half = wide / 2;
        return List.of(
                floor(friction),
                plane("West", new Vec3(-half, 0, 0), new Vec3(1, 0, 0), friction),
                plane("East", new Vec3(half, 0, 0), new Vec3(-1, 0, 0), friction),
                plane("South", new Vec3(0, -half, 0), new Vec3(0, 1, 0), friction),
                plane("North", new Vec3(0, half, 0), new Vec3(0, -1, 0), friction));
    }

    static WorldObjectDefinition.Builder heavy(String name, Volume volume) {
        return WorldObjectDefinition.named(name).volume(volume).mass(1).effect(new Gravity(G));
    }

    /** Kinetic energy of all that moves (J). */
    static double kineticEnergy(World world) {
        return world.objects().stream()
                .filter(o -> !o.isFixed())
                .mapToDouble(
                        o ->
                                o.linearMomentum().dot(o.velocity()) / 2
                                        + o.angularMomentum().dot(o.angularVelocity()) / 2)
                .sum();
    }

    /** Kinetic energy and that of height (J). */
    static double energy(World world) {
        return kineticEnergy(world)
                + world.objects().stream()
                        .filter(o -> !o.isFixed())
                        .mapToDouble(o -> o.mass() * G * centreOfMass(o).z())
                        .sum();
    }

    private static Vec3 centreOfMass(WorldObject o) {
        Vec3 inBody = o.definition().centreOfMass().orElse(o.volume().centreOfMass());
        return o.position().plus(o.orientation().rotate(inBody));
    }

    static void run(World world, double end) {
        while (world.time() < end) {
            world.advanceTimestep();
        }
    }

    static List<WorldObject> movers(World world) {
        return world.objects().stream().filter(o -> !o.isFixed()).toList();
    }
}
