package org.auvsim.experiments.distributed;

import org.auvsim.core.behavior.GoToPoint;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;

import java.util.List;
import java.util.Optional;

/** Five spheres that all head for one point, and meet there again and again. */
final class Scene {
    /** Where they all head for (m). */
    static final Vec3 TARGET = Vec3.ZERO;

    /** Where they start (m): chosen once and for all. */
    static final List<Vec3> STARTS =
            List.of(
                    new Vec3(4, 1, 0.5),
                    new Vec3(-3, 2, 1),
                    new Vec3(0.5, -5, -1),
                    new Vec3(-2, -1, 4),
                    new Vec3(1, 3, -3));

    /** The law by which each is driven. */
    static final GoToPoint LAW = new GoToPoint("drive", 2, 0.1, TARGET);

    private Scene() {}

    /** Its world, in which the spheres are driven by a behavior or by nobody; ids from 1. */
    static World world(Optional<Behavior> behavior) {
        WorldBuilder world = World.builder().timeStep(0.05);
        for (int k = 0; k < STARTS.size(); k++) {
            WorldObjectDefinition.Builder sphere =
                    WorldObjectDefinition.named("Sphere " + (k + 1))
                            .id(k + 1)
                            .volume(new Sphere(0.5))
                            .mass(1)
                            .restitution(0.8)
                            .friction(0.3)
                            .position(STARTS.get(k));
            behavior.ifPresent(sphere::component);
            world.add(sphere.build());
        }
        return world.build();
    }
}
