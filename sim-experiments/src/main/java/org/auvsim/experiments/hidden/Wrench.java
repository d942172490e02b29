package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

/** A force (N) and a torque about the body's origin (N m), world axes. */
record Wrench(Vector3D force, Vector3D torque) {
    static final Wrench NONE = new Wrench(Vector3D.ZERO, Vector3D.ZERO);

    static Wrench force(Vector3D force) {
        return new Wrench(force, Vector3D.ZERO);
    }

    static Wrench torque(Vector3D torque) {
        return new Wrench(Vector3D.ZERO, torque);
    }

    Wrench plus(Wrench other) {
        return new Wrench(force.add(other.force), torque.add(other.torque));
    }
}
