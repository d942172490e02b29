package org.auvsim.server;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;

/** The world of listing 7.1 of the thesis, with shapes and masses of ours. */
public final class Tank {
    private Tank() {}

    /** Bob, Carl, Tank and myAgent, far apart; myAgent has three thrusters. */
    public static World world() {
        return builder().build();
    }

    /** The same, to be added to. */
    public static WorldBuilder builder() {
        return World.builder()
                .timeStep(0.05)
                .add(ball(1, "Bob", 0, 0, 0))
                .add(ball(2, "Carl", 0, 100, 0))
                .add(ball(3, "Tank", 0, 200, 0))
                .add(
                        WorldObjectDefinition.named("myAgent")
                                .id(4)
                                .mass(2)
                                .volume(new Sphere(1))
                                .position(0, 300, 0)
                                .component(thruster("Aft Thruster"))
                                .component(thruster("Forward Thruster"))
                                .component(thruster("Ventral Thruster"))
                                .build());
    }

    /** A ball of 2 kg and 1 m radius. */
    public static WorldObjectDefinition ball(long id, String name, double x, double y, double z) {
        return WorldObjectDefinition.named(name)
                .id(id)
                .mass(2)
                .volume(new Sphere(1))
                .position(x, y, z)
                .build();
    }

    private static Propulsor thruster(String name) {
        return new Propulsor(name, 10, 0, Vec3.ZERO, new Vec3(1, 0, 0));
    }
}
