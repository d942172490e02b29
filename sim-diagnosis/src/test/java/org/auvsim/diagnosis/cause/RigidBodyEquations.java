package org.auvsim.diagnosis.cause;

import org.apache.commons.math3.geometry.euclidean.threed.Rotation;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.apache.commons.math3.ode.FirstOrderDifferentialEquations;
import org.apache.commons.math3.ode.nonstiff.DormandPrince853Integrator;

/**
 * Newton's and Euler's equations of a body about its centre of mass, with what it carries of the
 * water (Kirchhoff), integrated by Dormand and Prince: an oracle that shares nothing with the
 * simulator.
 *
 * @param mass along each body axis, carried water included (kg)
 * @param inertia about each body axis (kg m^2)
 */
record RigidBodyEquations(Vector3D mass, Vector3D inertia, Push push)
        implements FirstOrderDifferentialEquations {
    static final int SIZE = 13;
    private static final double ERROR = 1e-11;

    /** How a body moves: world axes, but the angular velocity. */
    record Now(
            double time, Vector3D place, Rotation attitude, Vector3D velocity, Vector3D turning) {
        Vector3D toBody(Vector3D world) {
            return attitude.applyInverseTo(world);
        }

        Vector3D toWorld(Vector3D body) {
            return attitude.applyTo(body);
        }
    }

    /** Force (N, world) and torque (N m, body) on it. */
    record Load(Vector3D force, Vector3D torque) {
        static Load force(Vector3D force) {
            return new Load(force, Vector3D.ZERO);
        }

        static Load torque(Vector3D torque) {
            return new Load(Vector3D.ZERO, torque);
        }

        Load plus(Load o) {
            return new Load(force.add(o.force), torque.add(o.torque));
        }
    }

    interface Push {
        Load at(Now now);
    }

    /** The state after some seconds: place, quaternion, velocity (world), turning (body). */
    double[] after(double seconds, double[] start) {
        double[] end = new double[SIZE];
        new DormandPrince853Integrator(1e-9, 0.05, ERROR, ERROR)
                .integrate(this, 0, start, seconds, end);
        return end;
    }

    static Now now(double time, double[] y) {
        return new Now(
                time,
                new Vector3D(y[0], y[1], y[2]),
                // Commons Math turns the other way round for a quaternion of these numbers.
                new Rotation(y[3], -y[4], -y[5], -y[6], true),
                new Vector3D(y[7], y[8], y[9]),
                new Vector3D(y[10], y[11], y[12]));
    }

    @Override
    public int getDimension() {
        return SIZE;
    }

    @Override
    public void computeDerivatives(double t, double[] y, double[] rate) {
        Now now = now(t, y);
        Load load = push.at(now);
        Vector3D w = now.turning();
        Vector3D v = now.toBody(now.velocity());
        Vector3D momentum = times(mass, v);
        Vector3D force = now.toBody(load.force()).subtract(w.crossProduct(momentum));
        Vector3D inBody = divided(force, mass).add(w.crossProduct(v));
        Vector3D spin = times(inertia, w);
        Vector3D torque =
                load.torque().subtract(w.crossProduct(spin)).subtract(v.crossProduct(momentum));
        put(rate, 0, now.velocity());
        rate[3] = -0.5 * (y[4] * w.getX() + y[5] * w.getY() + y[6] * w.getZ());
        rate[4] = 0.5 * (y[3] * w.getX() + y[5] * w.getZ() - y[6] * w.getY());
        rate[5] = 0.5 * (y[3] * w.getY() + y[6] * w.getX() - y[4] * w.getZ());
        rate[6] = 0.5 * (y[3] * w.getZ() + y[4] * w.getY() - y[5] * w.getX());
        put(rate, 7, now.toWorld(inBody));
        put(rate, 10, divided(torque, inertia));
    }

    static void put(double[] to, int at, Vector3D v) {
        to[at] = v.getX();
        to[at + 1] = v.getY();
        to[at + 2] = v.getZ();
    }

    static Vector3D times(Vector3D a, Vector3D b) {
        return new Vector3D(a.getX() * b.getX(), a.getY() * b.getY(), a.getZ() * b.getZ());
    }

    private static Vector3D divided(Vector3D a, Vector3D b) {
        return new Vector3D(a.getX() / b.getX(), a.getY() / b.getY(), a.getZ() / b.getZ());
    }
}
