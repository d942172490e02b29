package org.auvsim.core.sensor;

import org.auvsim.core.entity.Current;
import org.auvsim.core.math.Vec3;

/** The water as sensors meet it. */
final class Water {
    private Water() {}

    /** Its velocity (m/s, world) at a place (m, world), at the time of a sample. */
    static Vec3 velocity(Sample sample, Vec3 place) {
        Vec3 sum = Vec3.ZERO;
        for (Current current : sample.scene().currents()) {
            sum = sum.plus(current.valueAt(place, sample.now().time()));
        }
        return sum;
    }

    /** How deep (m) a place is below its surface, which waves raise over the still one. */
    static double depth(Sample sample, Vec3 place, double stillSurface) {
        double surface = stillSurface;
        for (Current current : sample.scene().currents()) {
            surface += current.elevation(place.x(), place.y(), sample.now().time());
        }
        return surface - place.z();
    }
}
