package org.auvsim.experiments.cfs;

import org.auvsim.core.behavior.BackAndForth;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;

/** The one object of the experiment, 1 kg, and the worlds that it is alone in. */
final class Vehicle {
    static final long ID = 1;
    static final double TIME_STEP = 0.05;

    /** Beyond this distance (m) from the middle it is pushed back, by 1 N. */
    static final double LIMIT = 2;

    /** Its speed (m/s) in the middle, at the beginning: it turns first at 2.5 m. */
    private static final double SPEED = 1;

    private static final Vec3 ALONG_Y = new Vec3(0, 1, 0);

    private Vehicle() {}

    /** A and B: it is pushed to and fro by a behavior that looks once a step where it is. */
    static World toAndFro(double timeStep) {
        return World.builder()
                .timeStep(timeStep)
                .add(
                        vehicle()
                                .velocity(0, SPEED, 0)
                                .component(new BackAndForth("push", 1, LIMIT, ALONG_Y))
                                .build())
                .build();
    }

    /** C: it rests, and only feedback moves it. */
    static World atRest() {
        return World.builder().timeStep(TIME_STEP).add(vehicle().build()).build();
    }

    private static WorldObjectDefinition.Builder vehicle() {
        return WorldObjectDefinition.named("AUV").id(ID).volume(new Sphere(0.5)).mass(1);
    }

    /** Where it is along y (m). */
    static double y(World world) {
        return world.object(ID).position().y();
    }
}
