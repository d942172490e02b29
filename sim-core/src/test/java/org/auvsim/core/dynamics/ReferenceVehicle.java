package org.auvsim.core.dynamics;

import org.apache.commons.math3.geometry.euclidean.threed.Rotation;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.LUDecomposition;
import org.apache.commons.math3.linear.RealMatrix;
import org.apache.commons.math3.ode.FirstOrderDifferentialEquations;
import org.apache.commons.math3.ode.nonstiff.DormandPrince853Integrator;
import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.RigidBody;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;

/**
 * A vehicle with full inertia, forces off its centre in both frames, weight, damping and a current,
 * written a second time: in velocities and Euler's equations in the body's axes, with Commons
 * Math's algebra, and solved by Dormand &amp; Prince 8(5,3) to 1e-12.
 */
final class ReferenceVehicle implements FirstOrderDifferentialEquations {
    private static final double MASS = 3;
    private static final Vector3D WORLD_FORCE = new Vector3D(0.5, -1, 2);
    private static final Vector3D WORLD_POINT = new Vector3D(0.2, 0.1, 0.3);
    private static final Vector3D BODY_FORCE = new Vector3D(4, 0.5, 0);
    private static final Vector3D BODY_POINT = new Vector3D(-0.5, 0.2, 0.1);
    private static final Vector3D CURRENT = new Vector3D(0.4, -0.3, 0.1);
    private static final Vector3D LINEAR = new Vector3D(0.5, 1, 1.5);
    private static final Vector3D ANGULAR_LINEAR = new Vector3D(0.3, 0.4, 0.5);
    private static final Vector3D VELOCITY = new Vector3D(2, 1, -0.5);
    private static final Vector3D TURN = new Vector3D(0.8, -0.6, 0.4);
    private static final double GRAVITY = 1.5;

    private final RealMatrix inertia =
            new Array2DRowRealMatrix(
                    new double[][] {{1, 0.1, -0.2}, {0.1, 2, 0.3}, {-0.2, 0.3, 2.5}});
    private final Vector3D quadratic;
    private final Vector3D angularQuadratic;
    private final RealMatrix inverse = new LUDecomposition(inertia).getSolver().getInverse();

    private ReferenceVehicle(Vector3D quadratic, Vector3D angularQuadratic) {
        this.quadratic = quadratic;
        this.angularQuadratic = angularQuadratic;
    }

    /** All that acts on it is smooth, so that a method shows its full order. */
    static ReferenceVehicle withSmoothForces() {
        return new ReferenceVehicle(Vector3D.ZERO, Vector3D.ZERO);
    }

    /** With quadratic damping, which has a kink where the velocity changes its sign. */
    static ReferenceVehicle withQuadraticDamping() {
        return new ReferenceVehicle(new Vector3D(1, 2, 3), new Vector3D(0.1, 0.2, 0.3));
    }

    /** The same vehicle by the equations under test. */
    Flight flight() {
        return Flight.of(
                        WorldObjectDefinition.named("vehicle")
                                .volume(new Sphere(1))
                                .mass(MASS)
                                .inertia(new Inertia(1, 2, 2.5, 0.1, -0.2, 0.3))
                                .velocity(VELOCITY.getX(), VELOCITY.getY(), VELOCITY.getZ())
                                .angularVelocity(TURN.getX(), TURN.getY(), TURN.getZ())
                                .force(force("world", Frame.WORLD, WORLD_FORCE, WORLD_POINT))
                                .force(force("body", Frame.BODY, BODY_FORCE, BODY_POINT)))
                .with(new Gravity(GRAVITY))
                .with(
                        new Damping(
                                vec(LINEAR),
                                vec(quadratic),
                                vec(ANGULAR_LINEAR),
                                vec(angularQuadratic)))
                .in(new UniformCurrent(1, "stream", vec(CURRENT)));
    }

    private static NamedForce force(String name, Frame frame, Vector3D vector, Vector3D point) {
        return new NamedForce(name, frame, vec(vector), vec(point));
    }

    private static Vec3 vec(Vector3D v) {
        return new Vec3(v.getX(), v.getY(), v.getZ());
    }

    /** Position, quaternion, velocity and body angular velocity after {@code time} s. */
    double[] solve(double time) {
        double[] y = new double[getDimension()];
        y[3] = 1;
        put(y, 7, VELOCITY);
        put(y, 10, TURN);
        new DormandPrince853Integrator(1e-8, 1, 1e-12, 1e-12).integrate(this, 0, y, time, y);
        return y;
    }

    /** How far a body is from a solution: the largest difference of place, velocity and turn. */
    double error(RigidBody body, double[] y) {
        Rotation turn = rotation(y);
        double place = body.position().distance(vec(vector(y, 0)));
        double speed = body.velocity().distance(vec(vector(y, 7)));
        double spin = body.angularVelocity().distance(vec(turn.applyTo(vector(y, 10))));
        double angle = 0;
        for (Vector3D axis : new Vector3D[] {Vector3D.PLUS_I, Vector3D.PLUS_J}) {
            Vec3 turned = body.orientation().rotate(vec(axis));
            angle = Math.max(angle, turned.distance(vec(turn.applyTo(axis))));
        }
        return Math.max(Math.max(place, speed), Math.max(spin, angle));
    }

    @Override
    public int getDimension() {
        return 13;
    }

    @Override
    public void computeDerivatives(double t, double[] y, double[] rate) {
        Rotation turn = rotation(y);
        Vector3D v = vector(y, 7);
        Vector3D w = vector(y, 10);
        Vector3D through = turn.applyInverseTo(v.subtract(CURRENT));
        Vector3D world = WORLD_FORCE.add(new Vector3D(0, 0, -MASS * GRAVITY));
        Vector3D body = BODY_FORCE.add(damping(through, LINEAR, quadratic));
        Vector3D torque =
                WORLD_POINT
                        .crossProduct(turn.applyInverseTo(WORLD_FORCE))
                        .add(BODY_POINT.crossProduct(BODY_FORCE))
                        .add(damping(w, ANGULAR_LINEAR, angularQuadratic));
        Vector3D momentum = product(inertia, w);
        put(rate, 0, v);
        putQuaternionRate(rate, y, w);
        put(rate, 7, world.add(turn.applyTo(body)).scalarMultiply(1 / MASS));
        put(rate, 10, product(inverse, torque.subtract(w.crossProduct(momentum))));
    }

    /** dq/dt = 1/2 q [0, w] with w in the body's axes. */
    private static void putQuaternionRate(double[] rate, double[] y, Vector3D w) {
        double scalar = y[3];
        Vector3D vector = vector(y, 4);
        rate[3] = -vector.dotProduct(w) / 2;
        put(rate, 4, w.scalarMultiply(scalar).add(vector.crossProduct(w)).scalarMultiply(0.5));
    }

    private static Vector3D damping(Vector3D v, Vector3D linear, Vector3D quadratic) {
        return new Vector3D(
                damping(v.getX(), linear.getX(), quadratic.getX()),
                damping(v.getY(), linear.getY(), quadratic.getY()),
                damping(v.getZ(), linear.getZ(), quadratic.getZ()));
    }

    private static double damping(double v, double linear, double quadratic) {
        return -linear * v - quadratic * v * Math.abs(v);
    }

    /** Body to world; Commons Math's quaternion turns the other way round. */
    private static Rotation rotation(double[] y) {
        return new Rotation(y[3], -y[4], -y[5], -y[6], true);
    }

    private static Vector3D vector(double[] y, int at) {
        return new Vector3D(y[at], y[at + 1], y[at + 2]);
    }

    private static void put(double[] y, int at, Vector3D v) {
        y[at] = v.getX();
        y[at + 1] = v.getY();
        y[at + 2] = v.getZ();
    }

    private static Vector3D product(RealMatrix matrix, Vector3D v) {
        return new Vector3D(matrix.operate(v.toArray()));
    }
}
