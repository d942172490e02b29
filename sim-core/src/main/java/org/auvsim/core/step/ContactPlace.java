package org.auvsim.core.step;

import org.auvsim.core.entity.BodyState;

/**
 * Where a contact is on a body, so that it is known again at another time: in the axes of the
 * pair's body with the lower slot, as it is turned in its present state.
 */
final class ContactPlace {
    private final BodyState bodies;
    private final ContactProblem problem;

    /** The place (m) that was found last. */
    double x;

    double y;
    double z;

    ContactPlace(BodyState bodies, ContactProblem problem) {
        this.bodies = bodies;
        this.problem = problem;
    }

    /** Finds a contact's place; balls touch at one place alone. */
    void find(int contact) {
        if (problem.contacts.isCentral[contact]) {
            x = 0;
            y = 0;
            z = 0;
            return;
        }
        int body = lower(problem.contacts.a[contact], problem.contacts.b[contact]);
        unturn(
                problem.slot(body),
                problem.contacts.px[contact] - problem.bodies.x[3 * body],
                problem.contacts.py[contact] - problem.bodies.x[3 * body + 1],
                problem.contacts.pz[contact] - problem.bodies.x[3 * body + 2]);
    }

    private int lower(int a, int b) {
        return problem.slot(a) < problem.slot(b) ? a : b;
    }

    /** Takes a vector (m, world) to a body's axes. */
    private void unturn(int slot, double rx, double ry, double rz) {
        double w = bodies.column(BodyState.QW)[slot];
        double qx = bodies.column(BodyState.QX)[slot];
        double qy = bodies.column(BodyState.QY)[slot];
        double qz = bodies.column(BodyState.QZ)[slot];
        double tx = 2 * (qz * ry - qy * rz);
        double ty = 2 * (qx * rz - qz * rx);
        double tz = 2 * (qy * rx - qx * ry);
        x = rx + w * tx + (qz * ty - qy * tz);
        y = ry + w * ty + (qx * tz - qz * tx);
        z = rz + w * tz + (qy * tx - qx * ty);
    }
}
