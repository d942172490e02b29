package org.auvsim.core.world;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.volume.Sphere;

/** Short forms for tests of the world. */
final class Balls {
    private Balls() {}

    /** A ball of 0.5 m and 1 kg. */
    static WorldObjectDefinition.Builder ball(String name) {
        return WorldObjectDefinition.named(name).volume(new Sphere(0.5)).mass(1);
    }

    /** A ball at rest on the x axis. */
    static WorldObjectDefinition at(String name, double x) {
        return ball(name).position(x, 0, 0).build();
    }
}
