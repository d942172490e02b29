package org.auvsim.core.dynamics;

import org.apache.commons.math3.geometry.euclidean.threed.Rotation;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.ArrayRealVector;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.MatrixUtils;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.linear.RealVector;
import org.apache.commons.math3.ode.FirstOrderDifferentialEquations;
import org.apache.commons.math3.ode.nonstiff.DormandPrince853Integrator;
import org.auvsim.core.effect.Buoyancy;
import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.RigidBody;
import org.auvsim.core.math.Vec3;

import java.util.OptionalDouble;

/**
 * {@link FullMassTest}'s vehicle written a second time, in the velocity form (Fossen 2021, equation
 * 6.52 and section 6.3): MRB nu' + CRB(nu) nu + MA nu_r' + CA(nu_r) nu_r = tau, where nu_c' is that
 * of the water that the moving origin meets. Weight, buoyancy and damping act and, where the water
 * moves unevenly, m_d Du/Dt at the centre of buoyancy and MA ((u - v) . grad) u (Auton, Hunt &amp;
 * Prud'homme 1988). Solved to 1e-14.
 */
final class FossenVehicle implements FirstOrderDifferentialEquations {
    private static final double LINEAR = 2;
    private static final double ANGULAR = 0.5;
    private static final double GRAVITY = 1.5;
    private static final Vector3D CENTRE = new Vector3D(0.1, -0.05, -0.2);
    private static final double DISPLACED = 9.8;
    private static final Vector3D BUOYANCY = new Vector3D(0.05, 0.02, 0.1);

    private final RealMatrix rigid = new Array2DRowRealMatrix(6, 6);
    private final RealMatrix added = new Array2DRowRealMatrix(6, 6);
    private final RealMatrix inverse;
    private final FossenWater water;

    FossenVehicle(FossenWater water) {
        this.water = water;
        RealMatrix s = skew(CENTRE);
        RealMatrix tensor =
                new Array2DRowRealMatrix(
                        new double[][] {{1, 0.1, -0.2}, {0.1, 2, 0.3}, {-0.2, 0.3, 2.5}});
        rigid.setSubMatrix(
                MatrixUtils.createRealIdentityMatrix(3).scalarMultiply(10).getData(), 0, 0);
        rigid.setSubMatrix(s.scalarMultiply(-10).getData(), 0, 3);
        rigid.setSubMatrix(s.scalarMultiply(10).getData(), 3, 0);
        rigid.setSubMatrix(tensor.subtract(s.multiply(s).scalarMultiply(10)).getData(), 3, 3);
        double[] diagonal = {1, 5, 8, 0.2, 2, 3};
        for (int i = 0; i < 6; i++) {
            added.setEntry(i, i, diagonal[i]);
        }
        added.setEntry(1, 5, 1.5);
        added.setEntry(5, 1, 1.5);
        added.setEntry(2, 4, -2);
        added.setEntry(4, 2, -2);
        inverse = new LUDecomposition(rigid.add(added)).getSolver().getInverse();
    }

    /** In the water from the beginning, when its velocity is stated. */
    Flight flight() {
        Vec3 ones = new Vec3(1, 1, 1);
        Flight flight =
                Flight.of(FullMassTest.vehicle())
                        .with(new Gravity(GRAVITY))
                        .with(
                                new Buoyancy(
                                        DISPLACED / 1000,
                                        1000,
                                        GRAVITY,
                                        vec(BUOYANCY),
                                        1000,
                                        OptionalDouble.empty()))
                        .with(
                                new Damping(
                                        ones.times(LINEAR),
                                        Vec3.ZERO,
                                        ones.times(ANGULAR),
                                        Vec3.ZERO));
        water.currents().forEach(flight::in);
        flight.body().setVelocity(new Vec3(1, 0.5, -0.3));
        flight.body().setAngularVelocity(new Vec3(0.4, -0.3, 0.6));
        return flight;
    }

    double[] solve(double time) {
        double[] y = new double[13];
        y[3] = 1;
        put(y, 7, new Vector3D(1, 0.5, -0.3));
        put(y, 10, new Vector3D(0.4, -0.3, 0.6));
        new DormandPrince853Integrator(1e-8, 1, 1e-14, 1e-14).integrate(this, 0, y, time, y);
        return y;
    }

    /** The largest error of place, velocity and angular velocity, each relative to its size. */
    double error(RigidBody body, double[] y) {
        Rotation turn = rotation(y);
        return Math.max(
                error(body.position(), vector(y, 0)),
                Math.max(
                        error(body.velocity(), turn.applyTo(vector(y, 7))),
                        error(body.angularVelocity(), turn.applyTo(vector(y, 10)))));
    }

    private static double error(Vec3 actual, Vector3D expected) {
        return actual.distance(vec(expected)) / Math.max(1, expected.getNorm());
    }

    @Override
    public int getDimension() {
        return 13;
    }

    @Override
    public void computeDerivatives(double t, double[] y, double[] rate) {
        Rotation turn = rotation(y);
        Vector3D place = vector(y, 0);
        Vector3D v = vector(y, 7);
        Vector3D w = vector(y, 10);
        Vector3D stream = water.velocity(place, t);
        Vector3D local = turn.applyInverseTo(stream);
        Vector3D through = v.subtract(local);
        Vector3D byTime = water.byTime(place, t);
        Vector3D met = byTime.add(water.along(place, t, turn.applyTo(v)));
        Vector3D flowing = byTime.add(water.along(place, t, stream));
        Vector3D weight = turn.applyInverseTo(new Vector3D(0, 0, -10 * GRAVITY));
        Vector3D lift =
                turn.applyInverseTo(
                        new Vector3D(0, 0, DISPLACED * GRAVITY).add(DISPLACED, flowing));
        RealVector nu = join(v, w);
        RealVector relative = join(through, w);
        RealVector waterRate =
                join(turn.applyInverseTo(met).subtract(w.crossProduct(local)), Vector3D.ZERO);
        RealVector uneven = join(turn.applyInverseTo(flowing.subtract(met)), Vector3D.ZERO);
        RealVector tau =
                join(
                        weight.add(lift).subtract(through.scalarMultiply(LINEAR)),
                        CENTRE.crossProduct(weight)
                                .add(BUOYANCY.crossProduct(lift))
                                .subtract(w.scalarMultiply(ANGULAR)));
        RealVector acceleration =
                inverse.operate(
                        tau.subtract(coriolis(rigid, nu).operate(nu))
                                .subtract(coriolis(added, relative).operate(relative))
                                .add(added.operate(waterRate.add(uneven))));
        put(rate, 0, turn.applyTo(v));
        Vector3D q = vector(y, 4);
        rate[3] = -q.dotProduct(w) / 2;
        put(rate, 4, w.scalarMultiply(y[3]).add(q.crossProduct(w)).scalarMultiply(0.5));
        System.arraycopy(acceleration.toArray(), 0, rate, 7, 6);
    }

    /** Fossen 2021, theorem 3.2. */
    private static RealMatrix coriolis(RealMatrix m, RealVector nu) {
        double[] p = m.operate(nu).toArray();
        RealMatrix c = new Array2DRowRealMatrix(6, 6);
        RealMatrix linear = skew(new Vector3D(p[0], p[1], p[2])).scalarMultiply(-1);
        c.setSubMatrix(linear.getData(), 0, 3);
        c.setSubMatrix(linear.getData(), 3, 0);
        c.setSubMatrix(skew(new Vector3D(p[3], p[4], p[5])).scalarMultiply(-1).getData(), 3, 3);
        return c;
    }

    private static RealMatrix skew(Vector3D a) {
        return new Array2DRowRealMatrix(
                new double[][] {
                    {0, -a.getZ(), a.getY()}, {a.getZ(), 0, -a.getX()}, {-a.getY(), a.getX(), 0}
                });
    }

    private static RealVector join(Vector3D a, Vector3D b) {
        return new ArrayRealVector(a.toArray(), b.toArray());
    }

    private static Rotation rotation(double[] y) {
        return new Rotation(y[3], -y[4], -y[5], -y[6], true);
    }

    private static Vector3D vector(double[] y, int at) {
        return new Vector3D(y[at], y[at + 1], y[at + 2]);
    }

    private static Vec3 vec(Vector3D v) {
        return new Vec3(v.getX(), v.getY(), v.getZ());
    }

    private static void put(double[] y, int at, Vector3D v) {
        y[at] = v.getX();
        y[at + 1] = v.getY();
        y[at + 2] = v.getZ();
    }
}
