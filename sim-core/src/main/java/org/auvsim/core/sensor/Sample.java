package org.auvsim.core.sensor;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

/**
 * All that a sensor may know for one reading.
 *
 * @param now how its body moves at the instant of the measurement
 * @param before how it moved at the sensor's instant before, or when the sensor was added
 * @param scene the world around it at that instant
 * @param noise the random numbers of this reading
 */
public record Sample(Kinematics now, Kinematics before, Scene scene, Noise noise) {
    /** How a sensor moves that sits at a place of its body (m, body), its axes turned. */
    public Kinematics at(Vec3 place, Quat axes) {
        return now.at(place, axes);
    }
}
