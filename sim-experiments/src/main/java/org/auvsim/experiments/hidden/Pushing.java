package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.auvsim.experiments.hidden.Manoeuvre.TimedPush;

import java.util.ArrayList;
import java.util.List;

/** Pushes from outside, one after another with pauses. */
record Pushing(double least, double most, double lever) {
    List<TimedPush> draw(double duration, Draws draws) {
        List<TimedPush> pushes = new ArrayList<>();
        double from = draws.between(0.2, 1.5);
        while (from < duration - 1) {
            double until = Math.min(duration, from + draws.between(1, 4));
            Vector3D force = draws.direction().scalarMultiply(draws.between(least, most));
            pushes.add(new TimedPush(from, until, force, draws.box(-lever, lever)));
            from = until + draws.between(0.3, 3);
        }
        return pushes;
    }

    /** Nearly at rest, under water. */
    static Instant start(Draws draws) {
        return new Instant(
                0,
                new Vector3D(0, 0, -10),
                Attitude.turned(new Vector3D(0, 0, draws.between(-Math.PI, Math.PI))),
                draws.normals(0.1),
                draws.normals(0.05),
                Vector3D.ZERO);
    }
}
