package org.auvsim.bench;

import org.auvsim.core.behavior.GoToPoint;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.step.Stepper;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;

import java.util.SplittableRandom;

/**
 * The workload of the thesis' section 8.2, made exact: equal spheres in cubes, each with a target
 * of its own, all targets of a cube close to each other, so that it collapses and collides.
 *
 * <p>Bodies come in clusters of at most 100, 60 m apart. A cluster of m fills the smallest cubic
 * lattice that holds it, centres 6 m apart (gaps of 5 diameters); its targets stand on a spiral on
 * a sphere of 2 m about its origin. A body is driven by 10 N, by a {@link GoToPoint} that looks
 * once a step, as behaviors do: the force stands still during the step and is off within 0.1 m of
 * the target. Positions are jittered, since clusters that are copies collide in bursts.
 *
 * @param bodies number of spheres (radius 0.5 m, 1 kg, restitution 1)
 * @param seed of the jitter
 */
public record Workload(int bodies, long seed) {
    private static final int CLUSTER = 100;
    private static final double CLUSTER_SPACING = 60;
    private static final double SPACING = 6;
    private static final double JITTER = 1e-6;
    private static final double FORCE = 10;
    private static final double REST_RADIUS = 0.1;
    private static final double TARGET_RADIUS = 2;
    private static final double GOLDEN_ANGLE = 2.399963;

    /** A world of this workload at DT 0.05 s, before its first step. */
    public World world(Stepper stepper) {
        WorldBuilder world = World.builder().timeStep(0.05).stepper(stepper);
        SplittableRandom random = new SplittableRandom(seed);
        int clusters = (bodies + CLUSTER - 1) / CLUSTER;
        for (int c = 0; c < clusters; c++) {
            Vec3 origin = lattice(c, side(clusters)).times(CLUSTER_SPACING);
            int members = Math.min(CLUSTER, bodies - c * CLUSTER);
            for (int j = 0; j < members; j++) {
                String name = "Sphere " + (c * CLUSTER + j + 1);
                world.add(sphere(name, origin, j, members, random));
            }
        }
        return world.build();
    }

    private static WorldObjectDefinition sphere(
            String name, Vec3 origin, int j, int members, SplittableRandom random) {
        int side = side(members);
        Vec3 centred = lattice(j, side).minus(new Vec3(side - 1, side - 1, side - 1).times(0.5));
        Vec3 jitter =
                new Vec3(
                        random.nextDouble(-JITTER, JITTER),
                        random.nextDouble(-JITTER, JITTER),
                        random.nextDouble(-JITTER, JITTER));
        Vec3 target = origin.plus(target(j, members));
        return WorldObjectDefinition.named(name)
                .volume(new Sphere(0.5))
                .mass(1)
                .restitution(1)
                .position(origin.plus(centred.times(SPACING)).plus(jitter))
                .component(new GoToPoint("drive", FORCE, REST_RADIUS, target))
                .build();
    }

    /** Side of the smallest cube of so many cells. */
    private static int side(int cells) {
        int side = 1;
        while (side * side * side < cells) {
            side++;
        }
        return side;
    }

    /** Cell {@code index} of a cube, in x, y, z order: x runs quickest. */
    private static Vec3 lattice(int index, int side) {
        int x = index % side;
        int y = index / side % side;
        int z = index / (side * side);
        return new Vec3(x, y, z);
    }

    private static Vec3 target(int j, int members) {
        double u = 2.0 * j / members - 1;
        double s = Math.sqrt(1 - u * u);
        double angle = GOLDEN_ANGLE * j;
        return new Vec3(StrictMath.cos(angle) * s, StrictMath.sin(angle) * s, u)
                .times(TARGET_RADIUS);
    }
}
