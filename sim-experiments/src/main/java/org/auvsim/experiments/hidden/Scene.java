package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

import java.util.List;
import java.util.stream.IntStream;

/**
 * What a body does as the model believes: by which effects are drawn that matter.
 *
 * @param shows whether its orientation is measured
 * @param falls whether nothing but weight and drag acts: mass and drag are then one number
 * @param duration of the shortest run (s)
 * @param range largest extent of the paths along an axis, mean of the runs (m)
 * @param turned largest turn from the first attitude, mean of the runs (rad)
 * @param speed typical (m/s)
 * @param places all over the paths
 */
record Scene(
        Plant plant,
        boolean shows,
        boolean falls,
        double duration,
        double range,
        double turned,
        double speed,
        List<Vector3D> places) {
    static Scene of(Plant plant, boolean shows, List<List<Pose>> runs, List<Manoeuvre> done) {
        double range = runs.stream().mapToDouble(Scene::range).average().orElseThrow();
        double turned = runs.stream().mapToDouble(Scene::turned).average().orElseThrow();
        double duration = done.stream().mapToDouble(Manoeuvre::duration).min().orElseThrow();
        double way = 0;
        double time = 0;
        for (int r = 0; r < runs.size(); r++) {
            List<Pose> run = runs.get(r);
            way +=
                    IntStream.range(1, run.size())
                            .mapToDouble(
                                    k -> run.get(k).position().distance(run.get(k - 1).position()))
                            .sum();
            time += done.get(r).duration();
        }
        List<Vector3D> places = runs.stream().flatMap(List::stream).map(Pose::position).toList();
        return new Scene(
                plant, shows, falls(plant, done), duration, range, turned, way / time, places);
    }

    private static boolean falls(Plant plant, List<Manoeuvre> done) {
        return plant.displaced() == 0
                && plant.thrusters().isEmpty()
                && done.stream().allMatch(manoeuvre -> manoeuvre.pushes().isEmpty());
    }

    private static double range(List<Pose> run) {
        double[] low = {1e300, 1e300, 1e300};
        double[] high = {-1e300, -1e300, -1e300};
        double range = 0;
        for (Pose pose : run) {
            double[] p = pose.position().toArray();
            for (int axis = 0; axis < p.length; axis++) {
                low[axis] = Math.min(low[axis], p[axis]);
                high[axis] = Math.max(high[axis], p[axis]);
                range = Math.max(range, high[axis] - low[axis]);
            }
        }
        return range;
    }

    private static double turned(List<Pose> run) {
        Attitude first = run.getFirst().attitude();
        return run.stream().mapToDouble(pose -> pose.attitude().angleTo(first)).max().orElse(0);
    }

    /** The range of turns (rad) that noise and changes are compared with: not quite nothing. */
    double turns() {
        return Math.max(0.3, turned);
    }

    /** A place off the paths, as far as a share of their range at least. */
    Vector3D besidePaths(double share, Draws draws) {
        for (double reach = share; ; reach *= 1.1) {
            Vector3D place =
                    draws.oneOf(places).add(draws.direction().scalarMultiply(1.5 * reach * range));
            double nearest =
                    places.stream().mapToDouble(place::distance).min().orElse(Double.MAX_VALUE);
            if (nearest > share * range) {
                return place;
            }
        }
    }
}
