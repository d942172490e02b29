package org.auvsim.experiments.workload;

import org.auvsim.core.math.Vec3;

/** Where the spheres of a cluster are driven to. */
public enum Targets {
    /** Each to one of its own, all of them on a spiral on a sphere of 2 m about the origin. */
    OWN {
        @Override
        Vec3 of(int member, int members) {
            double u = 2.0 * member / members - 1;
            double s = Math.sqrt(1 - u * u);
            double angle = GOLDEN_ANGLE * member;
            return new Vec3(StrictMath.cos(angle) * s, StrictMath.sin(angle) * s, u).times(2);
        }
    },
    /** All to the origin: the cube collapses and expands over and over. */
    COMMON {
        @Override
        Vec3 of(int member, int members) {
            return Vec3.ZERO;
        }
    };

    /** Turns from one point of the spiral to the next (rad). */
    private static final double GOLDEN_ANGLE = 2.399963;

    /** The target (m, from the cluster's origin) of one of the members. */
    abstract Vec3 of(int member, int members);
}
