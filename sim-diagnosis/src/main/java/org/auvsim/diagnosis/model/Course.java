package org.auvsim.diagnosis.model;

import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;

/** A motion between its samples: the cubic that has both ends and their velocities (Hermite). */
final class Course {
    private static final int HALF = RigidMotion.SIZE / 2;

    private Course() {}

    /**
     * The motion at a time (s). Before the first sample and after the last it goes on as it is
     * there: a vehicle that begins to be driven was at rest or moved evenly, and a cubic leads
     * anywhere.
     *
     * @param motions at a run's samples from {@code from} on
     */
    static RigidMotion at(RigidMotion[] motions, MeasuredRun run, int from, double time) {
        if (motions.length == 1) {
            return goingOn(motions[0], time - run.time(from));
        }
        int low = 0;
        int high = motions.length - 1;
        while (high - low > 1) {
            int middle = (low + high) >>> 1;
            if (run.time(from + middle) <= time) {
                low = middle;
            } else {
                high = middle;
            }
        }
        double begin = run.time(from + low);
        double span = run.time(from + low + 1) - begin;
        double share = (time - begin) / span;
        if (share < 0) {
            return goingOn(motions[low], time - begin);
        }
        return share > 1
                ? goingOn(motions[low + 1], time - begin - span)
                : between(motions[low], motions[low + 1], span, share);
    }

    private static RigidMotion goingOn(RigidMotion motion, double span) {
        double[] change = new double[RigidMotion.SIZE];
        double[] velocities = velocities(motion);
        for (int i = 0; i < HALF; i++) {
            change[i] = span * velocities[i];
        }
        return motion.plus(change);
    }

    private static RigidMotion between(RigidMotion a, RigidMotion b, double span, double s) {
        double[] way = b.minus(a);
        double[] before = velocities(a);
        double[] after = velocities(b);
        double[] change = new double[RigidMotion.SIZE];
        for (int i = 0; i < HALF; i++) {
            double atStart = span * before[i];
            double atEnd = span * after[i];
            change[i] =
                    way[i] * s * s * (3 - 2 * s)
                            + atStart * s * (1 - s) * (1 - s)
                            - atEnd * s * s * (1 - s);
            double slope =
                    way[i] * 6 * s * (1 - s)
                            + atStart * (1 - s) * (1 - 3 * s)
                            + atEnd * s * (3 * s - 2);
            change[HALF + i] = slope / span - before[i];
        }
        return a.plus(change);
    }

    private static double[] velocities(RigidMotion m) {
        return new double[] {
            m.velocity().x(),
            m.velocity().y(),
            m.velocity().z(),
            m.angularVelocity().x(),
            m.angularVelocity().y(),
            m.angularVelocity().z()
        };
    }
}
