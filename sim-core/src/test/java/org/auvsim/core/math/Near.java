package org.auvsim.core.math;

import static org.assertj.core.api.Assertions.assertThat;

/** Assertions that geometry agrees within a distance. */
public final class Near {
    private Near() {}

    /** Fails unless the vectors are at most {@code distance} apart. */
    public static void assertNear(Vec3 actual, Vec3 expected, double distance) {
        assertThat(actual.distance(expected))
                .as("distance of %s from %s", actual, expected)
                .isLessThanOrEqualTo(distance);
    }

    /** Fails unless no element differs by more than {@code difference}. */
    public static void assertNear(Mat3 actual, Mat3 expected, double difference) {
        for (Vec3 axis : new Vec3[] {new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1)}) {
            assertNear(actual.times(axis), expected.times(axis), difference);
        }
    }
}
