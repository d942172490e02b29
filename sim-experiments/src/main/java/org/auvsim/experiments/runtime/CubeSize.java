package org.auvsim.experiments.runtime;

import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.auvsim.experiments.workload.Targets;
import org.auvsim.experiments.workload.Workload;
import org.auvsim.plot.page.Curve.Point;

import java.util.ArrayList;
import java.util.List;

/** The mean distance (m) of a cube's spheres from its middle over time (s). */
record CubeSize(int bodies, List<Point> ownTargets, List<Point> oneTarget) {
    static CubeSize watch(Workload workload, double seconds) {
        return new CubeSize(
                workload.bodies(),
                sizes(workload.withTargets(Targets.OWN), seconds),
                sizes(workload.withTargets(Targets.COMMON), seconds));
    }

    private static List<Point> sizes(Workload workload, double seconds) {
        World world = workload.world().build();
        List<Point> sizes = new ArrayList<>();
        while (world.time() < seconds) {
            sizes.add(new Point(world.time(), size(world)));
            world.advanceTimestep();
        }
        return sizes;
    }

    private static double size(World world) {
        return world.objects().stream()
                .map(WorldObject::position)
                .mapToDouble(Vec3::norm)
                .average()
                .orElse(0);
    }
}
