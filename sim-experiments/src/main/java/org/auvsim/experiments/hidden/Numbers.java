package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

import java.util.List;

/** Parameters as lists. */
final class Numbers {
    private Numbers() {}

    static List<Double> of(double value) {
        return List.of(value);
    }

    static List<Double> of(Vector3D v) {
        return List.of(v.getX(), v.getY(), v.getZ());
    }
}
