package org.auvsim.core.step;

import org.auvsim.core.volume.Pose;

import java.util.Arrays;

/**
 * How one body moves over a segment [from, to] of time: its position by the cubic that has the same
 * positions and velocities at both ends, its orientation by the normalised cubic Hermite curve of
 * the quaternion, from q and dq/dt = 1/2 [0, w] q at both ends (error 1e-6 rad at 0.05 s for
 * ordinary spins). Both are held as Bezier control points.
 *
 * <p>Mutable, owned by the caller, who loads it anew for each body. Bounds are upper bounds of the
 * curve itself, never too small. Times are in s, on whatever clock the caller loads.
 */
final class BodyCurve {
    /** What rounding could take from a bound is put on top. */
    private static final double ROUND_UP = 1 + 1e-12;

    private final double[] path = new double[12];
    private final double[] turn = new double[16];
    private final double[] slopes = new double[12];
    private double from;
    private double to;
    private boolean turns;
    private boolean moves;
    private double angularSpeed;
    private double angularBend;

    /**
     * Loads a path from 4 Bezier points (x, y, z, m), for an orientation that is to be set next.
     */
    void path(double from, double to, double[] points, int at) {
        this.from = from;
        this.to = to;
        System.arraycopy(points, at, path, 0, 12);
        moves = true;
    }

    /** Stands still in a pose, as a fixed body. */
    void rest(double from, double to, Pose pose) {
        this.from = from;
        this.to = to;
        for (int at = 0; at < 12; at += 3) {
            path[at] = pose.x;
            path[at + 1] = pose.y;
            path[at + 2] = pose.z;
        }
        moves = false;
        unturned(pose.qw, pose.qx, pose.qy, pose.qz);
    }

    /** Keeps one orientation all along the path. */
    void unturned(double qw, double qx, double qy, double qz) {
        turn[0] = qw;
        turn[1] = qx;
        turn[2] = qy;
        turn[3] = qz;
        turns = false;
    }

    /**
     * Orientation and angular velocity (rad/s, world) where the path begins; {@link #turnTo} next.
     */
    void turnFrom(double qw, double qx, double qy, double qz, double wx, double wy, double wz) {
        turns = wx != 0 || wy != 0 || wz != 0;
        hermite(0, 4, (to - from) / 6, qw, qx, qy, qz, wx, wy, wz);
    }

    /**
     * Orientation and angular velocity (rad/s, world) where the path ends. The quaternion is the
     * one that integration from the beginning led to: its sign counts.
     */
    void turnTo(double qw, double qx, double qy, double qz, double wx, double wy, double wz) {
        hermite(12, 8, (from - to) / 6, qw, qx, qy, qz, wx, wy, wz);
        turns |= wx != 0 || wy != 0 || wz != 0;
        turns |= qw != turn[0] || qx != turn[1] || qy != turn[2] || qz != turn[3];
    }

    /** An end point and its neighbour at {@code sixth} (s) times [0, w] q from it. */
    private void hermite(
            int end,
            int inner,
            double sixth,
            double qw,
            double qx,
            double qy,
            double qz,
            double wx,
            double wy,
            double wz) {
        turn[end] = qw;
        turn[end + 1] = qx;
        turn[end + 2] = qy;
        turn[end + 3] = qz;
        turn[inner] = qw + sixth * (-wx * qx - wy * qy - wz * qz);
        turn[inner + 1] = qx + sixth * (wx * qw + wy * qz - wz * qy);
        turn[inner + 2] = qy + sixth * (wy * qw + wz * qx - wx * qz);
        turn[inner + 3] = qz + sixth * (wz * qw + wx * qy - wy * qx);
    }

    double from() {
        return from;
    }

    double to() {
        return to;
    }

    /** Whether the orientation changes at all. */
    boolean turns() {
        return turns;
    }

    /** Where the body is at {@code time}, which lies in the segment. */
    void poseAt(double time, Pose pose) {
        double s = moves || turns ? share(time) : 0;
        if (moves) {
            pose.x = Bezier.cubic(path, 0, 3, s);
            pose.y = Bezier.cubic(path, 1, 3, s);
            pose.z = Bezier.cubic(path, 2, 3, s);
        } else {
            pose.x = path[0];
            pose.y = path[1];
            pose.z = path[2];
        }
        if (turns) {
            turnAt(s, pose);
        } else {
            pose.qw = turn[0];
            pose.qx = turn[1];
            pose.qy = turn[2];
            pose.qz = turn[3];
        }
    }

    private void turnAt(double s, Pose pose) {
        double w = Bezier.cubic(turn, 0, 4, s);
        double x = Bezier.cubic(turn, 1, 4, s);
        double y = Bezier.cubic(turn, 2, 4, s);
        double z = Bezier.cubic(turn, 3, 4, s);
        double scale = 1 / Math.sqrt(w * w + x * x + y * y + z * z);
        pose.qw = w * scale;
        pose.qx = x * scale;
        pose.qy = y * scale;
        pose.qz = z * scale;
    }

    /** Writes the angular velocity (rad/s, world) at {@code time}, which lies in the segment. */
    void spinAt(double time, double[] spin, int at) {
        if (!turns || !(to > from)) {
            Arrays.fill(spin, at, at + 3, 0);
            return;
        }
        double s = share(time);
        double w = Bezier.cubic(turn, 0, 4, s);
        double x = Bezier.cubic(turn, 1, 4, s);
        double y = Bezier.cubic(turn, 2, 4, s);
        double z = Bezier.cubic(turn, 3, 4, s);
        differences(turn, 4, 12, 3 / (to - from));
        double dw = Bezier.quadratic(slopes, 0, 4, s, s);
        double dx = Bezier.quadratic(slopes, 1, 4, s, s);
        double dy = Bezier.quadratic(slopes, 2, 4, s, s);
        double dz = Bezier.quadratic(slopes, 3, 4, s, s);
        double scale = 2 / (w * w + x * x + y * y + z * z);
        spin[at] = scale * (dx * w - dw * x - dy * z + dz * y);
        spin[at + 1] = scale * (dy * w - dw * y - dz * x + dx * z);
        spin[at + 2] = scale * (dz * w - dw * z - dx * y + dy * x);
    }

    private double share(double time) {
        return to > from ? Math.min(1, Math.max(0, (time - from) / (to - from))) : 0;
    }

    /** Writes the 4 Bezier points (x, y, z, m) of the path between two times of the segment. */
    void pathWithin(double t0, double t1, double[] points, int at) {
        double s0 = share(t0);
        double s1 = share(t1);
        for (int axis = 0; axis < 3; axis++) {
            points[at + axis] = Bezier.cubic(path, axis, 3, s0);
            points[at + 3 + axis] = Bezier.cubic(path, axis, 3, s0, s0, s1);
            points[at + 6 + axis] = Bezier.cubic(path, axis, 3, s0, s1, s1);
            points[at + 9 + axis] = Bezier.cubic(path, axis, 3, s1);
        }
    }

    /**
     * Writes the 3 Bezier points of the velocity (x, y, z, m/s) between two times of the segment,
     * in whose hull the velocity stays.
     */
    void velocityWithin(double t0, double t1, double[] points, int at) {
        if (!moves || !(to > from)) {
            Arrays.fill(points, at, at + 9, 0);
            return;
        }
        double s0 = share(t0);
        double s1 = share(t1);
        double rate = 3 / (to - from);
        differences(path, 3, 9, rate);
        for (int axis = 0; axis < 3; axis++) {
            points[at + axis] = Bezier.quadratic(slopes, axis, 3, s0, s0);
            points[at + 3 + axis] = Bezier.quadratic(slopes, axis, 3, s0, s1);
            points[at + 6 + axis] = Bezier.quadratic(slopes, axis, 3, s1, s1);
        }
    }

    /** Writes the acceleration (x, y, z, m/s^2) at two times; in between it is linear. */
    void accelerationAt(double t0, double t1, double[] points, int at) {
        if (!moves || !(to > from)) {
            Arrays.fill(points, at, at + 6, 0);
            return;
        }
        double s0 = share(t0);
        double s1 = share(t1);
        double rate = 6 / ((to - from) * (to - from));
        for (int axis = 0; axis < 3; axis++) {
            double p1 = path[axis + 3];
            double p2 = path[axis + 6];
            double first = rate * ((path[axis] - p1) + (p2 - p1));
            double last = rate * ((p1 - p2) + (path[axis + 9] - p2));
            points[at + axis] = first + s0 * (last - first);
            points[at + 3 + axis] = first + s1 * (last - first);
        }
    }

    /**
     * Finds bounds of how the body turns between two times of the segment: of the normalised curve
     * u = q / |q|, |w| = 2 |u'| is at most 2 |q'| / |q|, and |w'| + |w|^2 at most 2 |q''| / |q| + 6
     * |q'|^2 / |q|^2. Derivatives stay in the hull of their control points; |q| is at least the
     * least of the control points along the middle of the ends.
     */
    void boundTurn(double t0, double t1) {
        angularSpeed = 0;
        angularBend = 0;
        if (!turns || !(to > from)) {
            return;
        }
        double s0 = share(t0);
        double s1 = share(t1);
        double length = leastLength(s0, s1);
        if (!(length > 0)) {
            angularSpeed = Double.POSITIVE_INFINITY;
            angularBend = Double.POSITIVE_INFINITY;
            return;
        }
        differences(turn, 4, 12, 3 / (to - from));
        double first = 0;
        double middle = 0;
        double last = 0;
        double bend0 = 0;
        double bend1 = 0;
        for (int k = 0; k < 4; k++) {
            first += square(Bezier.quadratic(slopes, k, 4, s0, s0));
            middle += square(Bezier.quadratic(slopes, k, 4, s0, s1));
            last += square(Bezier.quadratic(slopes, k, 4, s1, s1));
            double rise = slopes[k + 4] - slopes[k];
            double change = (slopes[k + 8] - slopes[k + 4]) - rise;
            bend0 += square(rise + s0 * change);
            bend1 += square(rise + s1 * change);
        }
        double slope = Math.sqrt(Math.max(first, Math.max(middle, last))) / length;
        double bend = Math.sqrt(Math.max(bend0, bend1)) * 2 / ((to - from) * length);
        angularSpeed = 2 * slope * ROUND_UP;
        angularBend = (2 * bend + 6 * slope * slope) * ROUND_UP;
    }

    /** Greatest angular speed (rad/s) of what {@link #boundTurn} looked at; infinite if unknown. */
    double angularSpeed() {
        return angularSpeed;
    }

    /**
     * Greatest |w'| + |w|^2 (1/s^2) there: how fast the velocity of a point 1 m from the origin can
     * change by turning.
     */
    double angularBend() {
        return angularBend;
    }

    /** No more than the length of the cubic quaternion between two shares of the segment. */
    private double leastLength(double s0, double s1) {
        double ww = 0;
        double inner0 = 0;
        double inner1 = 0;
        double end0 = 0;
        double end1 = 0;
        for (int k = 0; k < 4; k++) {
            double q0 = Bezier.cubic(turn, k, 4, s0);
            double q1 = Bezier.cubic(turn, k, 4, s1);
            double along = q0 + q1;
            ww += along * along;
            end0 += along * q0;
            end1 += along * q1;
            inner0 += along * Bezier.cubic(turn, k, 4, s0, s0, s1);
            inner1 += along * Bezier.cubic(turn, k, 4, s0, s1, s1);
        }
        double least = Math.min(Math.min(end0, end1), Math.min(inner0, inner1));
        return least / Math.sqrt(ww);
    }

    /** Makes the slopes the control points of a cubic's derivative. */
    private void differences(double[] points, int dimensions, int count, double rate) {
        for (int i = 0; i < count; i++) {
            slopes[i] = rate * (points[i + dimensions] - points[i]);
        }
    }

    private static double square(double x) {
        return x * x;
    }
}
