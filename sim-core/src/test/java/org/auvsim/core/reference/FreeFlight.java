package org.auvsim.core.reference;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Pose;

/**
 * The exact motion of a body under a constant force at its centre of mass: a parabola, and the free
 * rotation about it, whose angular momentum is constant (Goldstein, Classical Mechanics, 3rd ed.,
 * section 5.6). The rotation is integrated with a step so short that its error is below 1e-10 rad
 * for the angular speeds of the tests.
 */
final class FreeFlight implements Flight {
    private static final double STEP = 1.0 / 512;

    private final double[] place;
    private final double[] velocity;
    private final double[] acceleration;
    private final double[] angularMomentum = new double[3];
    private final double[] inertia;

    /** At every step, as far as was asked for. */
    private final double[][] turns;

    private int lastTurn;
    private final double[] turn = new double[4];
    private final double[][] slopes = new double[4][4];
    private final double[] stage = new double[4];
    private final Placement now = new Placement();

    /**
     * A flight.
     *
     * @param inertia about the body's principal axes, which are its own (kg m^2)
     * @param orientation quaternion (w, x, y, z), body to world
     * @param spin angular velocity (rad/s, world)
     * @param end how long it is followed (s)
     */
    FreeFlight(
            double[] place,
            double[] velocity,
            double[] acceleration,
            double[] inertia,
            double[] orientation,
            double[] spin,
            double end) {
        this.place = place;
        this.velocity = velocity;
        this.acceleration = acceleration;
        this.inertia = inertia;
        now.set(0, 0, 0, orientation);
        double[] r = now.turn;
        for (int axis = 0; axis < 3; axis++) {
            double w = r[axis] * spin[0] + r[3 + axis] * spin[1] + r[6 + axis] * spin[2];
            for (int i = 0; i < 3; i++) {
                angularMomentum[i] += r[3 * i + axis] * inertia[axis] * w;
            }
        }
        turns = new double[(int) Math.ceil(end / STEP) + 1][];
        turns[0] = orientation.clone();
    }

    @Override
    public Placement at(double t) {
        int before = Math.min(turns.length - 1, (int) (t / STEP));
        while (lastTurn < before) {
            double[] next = turns[lastTurn].clone();
            advance(next, STEP);
            lastTurn++;
            turns[lastTurn] = next;
        }
        System.arraycopy(turns[before], 0, turn, 0, 4);
        advance(turn, t - before * STEP);
        now.set(along(0, t), along(1, t), along(2, t), turn);
        return now;
    }

    /** The same for the engine. */
    Pose pose(double t) {
        Placement place = at(t);
        Quat q = new Quat(turn[0], turn[1], turn[2], turn[3]).normalized();
        Pose pose = new Pose();
        pose.set(new Vec3(place.at[0], place.at[1], place.at[2]), q);
        return pose;
    }

    private double along(int axis, double t) {
        return place[axis] + (velocity[axis] + acceleration[axis] * t / 2) * t;
    }

    @Override
    public double velocity(int axis, double t) {
        return velocity[axis] + acceleration[axis] * t;
    }

    @Override
    public double speedBound(double from, double to) {
        double now = 0;
        double more = 0;
        for (int i = 0; i < 3; i++) {
            now += velocity(i, from) * velocity(i, from);
            more += acceleration[i] * acceleration[i];
        }
        return Math.sqrt(now) + Math.sqrt(more) * (to - from);
    }

    @Override
    public double spinBound() {
        double least = Math.min(inertia[0], Math.min(inertia[1], inertia[2]));
        return Math.sqrt(
                        angularMomentum[0] * angularMomentum[0]
                                + angularMomentum[1] * angularMomentum[1]
                                + angularMomentum[2] * angularMomentum[2])
                / least;
    }

    private void advance(double[] q, double h) {
        slope(q, slopes[0]);
        slope(shifted(q, slopes[0], h / 2), slopes[1]);
        slope(shifted(q, slopes[1], h / 2), slopes[2]);
        slope(shifted(q, slopes[2], h), slopes[3]);
        for (int i = 0; i < 4; i++) {
            q[i] += h / 6 * (slopes[0][i] + 2 * slopes[1][i] + 2 * slopes[2][i] + slopes[3][i]);
        }
    }

    private double[] shifted(double[] q, double[] slope, double h) {
        for (int i = 0; i < 4; i++) {
            stage[i] = q[i] + h * slope[i];
        }
        return stage;
    }

    /** dq/dt = q [0, w] / 2 with w in body axes, from the constant angular momentum. */
    private void slope(double[] q, double[] to) {
        now.set(0, 0, 0, q);
        double[] r = now.turn;
        double[] l = angularMomentum;
        double wx = (r[0] * l[0] + r[3] * l[1] + r[6] * l[2]) / inertia[0] / 2;
        double wy = (r[1] * l[0] + r[4] * l[1] + r[7] * l[2]) / inertia[1] / 2;
        double wz = (r[2] * l[0] + r[5] * l[1] + r[8] * l[2]) / inertia[2] / 2;
        to[0] = -q[1] * wx - q[2] * wy - q[3] * wz;
        to[1] = q[0] * wx + q[2] * wz - q[3] * wy;
        to[2] = q[0] * wy + q[3] * wx - q[1] * wz;
        to[3] = q[0] * wz + q[1] * wy - q[2] * wx;
    }
}
