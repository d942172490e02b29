package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.data.Offset.offset;

import org.auvsim.core.math.Draws;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Pose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BodyCurveTest {
    private static final double DT = 0.05;

    private final BodyCurve curve = new BodyCurve();
    private final Pose pose = new Pose();

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void aTumblingBodyIsTracedToAMillionthOfARadian(long seed) {
        Draws draws = new Draws(seed);
        Mat3 inertia = Mat3.diagonal(1, draws.number(1, 4), draws.number(2, 4));
        Tumbling start = new Tumbling(inertia, draws.orientation(), draws.vector(1.5));
        Tumbling end = start.after(DT);
        load(start, end);
        for (int i = 0; i <= 10; i++) {
            double t = DT * i / 10;
            curve.poseAt(t, pose);
            Quat apart = start.after(t).orientation().conjugate().times(pose.orientation());
            double angle =
                    2
                            * Math.sqrt(
                                    apart.x() * apart.x()
                                            + apart.y() * apart.y()
                                            + apart.z() * apart.z());
            assertThat(angle).isLessThan(1e-6);
        }
    }

    private void load(Tumbling start, Tumbling end) {
        curve.path(0, DT, new double[12], 0);
        Quat p = start.orientation();
        Vec3 v = start.angularVelocity();
        curve.turnFrom(p.w(), p.x(), p.y(), p.z(), v.x(), v.y(), v.z());
        Quat q = end.orientation();
        Vec3 w = end.angularVelocity();
        curve.turnTo(q.w(), q.x(), q.y(), q.z(), w.x(), w.y(), w.z());
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {11, 12, 13})
    void boundsHoldEverywhereAndAreNotFarOff(long seed) {
        Draws draws = new Draws(seed);
        double[] v = new double[9];
        double[] a = new double[6];
        for (int i = 0; i < 300; i++) {
            BodyCurve drawn = Leg.drawn(draws, 3, draws.number(0.1, 1.5)).curve();
            double t0 = draws.number(0, 0.9);
            double t1 = draws.number(t0, 1);
            drawn.boundTurn(t0, t1);
            Vec3 n = draws.direction();
            drawn.velocityWithin(t0, t1, v, 0);
            drawn.accelerationAt(t0, t1, a, 0);
            double fastest = 0;
            for (int k = 1; k < 40; k++) {
                double t = t0 + (t1 - t0) * k / 40;
                double h = 1e-5;
                double spin = turn(drawn, t - h, t + h) / (2 * h);
                fastest = Math.max(fastest, spin);
                assertThat(spin).isLessThan(drawn.angularSpeed() * (1 + 1e-6) + 1e-6);
                double along = velocity(drawn, t, h).dot(n);
                assertThat(along).isBetween(along(v, n, false) - 1e-6, along(v, n, true) + 1e-6);
                double pull = acceleration(drawn, t, 1e-4).dot(n);
                assertThat(pull).isBetween(along(a, n, false) - 1e-4, along(a, n, true) + 1e-4);
            }
            assertThat(drawn.angularSpeed()).isLessThan(3 * fastest + 0.1);
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {21, 22})
    void pointsOfABodyBendNoMoreThanTheBound(long seed) {
        Draws draws = new Draws(seed);
        for (int i = 0; i < 300; i++) {
            Leg still = Leg.drawn(draws, 1e-300, draws.number(0.1, 1.5));
            BodyCurve drawn = still.curve();
            Vec3 point = draws.direction();
            drawn.boundTurn(0, 1);
            for (int k = 1; k < 20; k++) {
                double bend = secondDifference(drawn, point, k / 20.0, 1e-4).norm();
                assertThat(bend).isLessThan(drawn.angularBend() * (1 + 1e-6) + 1e-6);
            }
        }
    }

    @Test
    void anEvenTurnHasItsOwnSpeedAsBound() {
        Vec3 w = new Vec3(0.1, -0.2, 0.3);
        BodyCurve even = Leg.straight(Vec3.ZERO, Vec3.ZERO, Quat.IDENTITY, w).curve();
        even.boundTurn(0.4, 0.6);
        assertThat(even.angularSpeed()).isBetween(w.norm(), w.norm() * 1.001);
        assertThat(even.angularBend()).isBetween(w.dot(w), 2.01 * w.dot(w));
    }

    @Test
    void aBodyThatDoesNotTurnHasNoTurnBounds() {
        Quat q = Quat.ofAxisAngle(new Vec3(1, 2, 3), 1);
        BodyCurve straight = Leg.straight(Vec3.ZERO, new Vec3(1, 0, 0), q, Vec3.ZERO).curve();
        assertThat(straight.turns()).isFalse();
        straight.boundTurn(0, 1);
        assertThat(straight.angularSpeed()).isZero();
        assertThat(straight.angularBend()).isZero();
        straight.poseAt(0.5, pose);
        assertThat(pose.orientation()).isEqualTo(q);
        assertThat(pose.x).isCloseTo(0.5, offset(1e-15));
    }

    @Test
    void endsAreExact() {
        Leg leg = Leg.drawn(new Draws(31), 5, 1);
        leg.curve().poseAt(0, pose);
        assertThat(pose.position()).isEqualTo(leg.p0());
        leg.curve().poseAt(1, pose);
        assertThat(pose.position()).isEqualTo(leg.p1());
    }

    @Test
    void aPartOfAPathLiesOnIt() {
        BodyCurve whole = Leg.drawn(new Draws(32), 5, 1).curve();
        double[] points = new double[12];
        whole.pathWithin(0.2, 0.7, points, 0);
        BodyCurve part = new BodyCurve();
        part.path(0.2, 0.7, points, 0);
        part.unturned(1, 0, 0, 0);
        for (double t : new double[] {0.2, 0.3, 0.55, 0.7}) {
            whole.poseAt(t, pose);
            Vec3 expected = pose.position();
            part.poseAt(t, pose);
            assertThat(pose.position().distance(expected)).isLessThan(1e-14);
        }
    }

    /** The angle (rad) between the orientations at two near times. */
    private double turn(BodyCurve of, double t0, double t1) {
        of.poseAt(t0, pose);
        Quat first = pose.orientation();
        of.poseAt(t1, pose);
        Quat apart = first.conjugate().times(pose.orientation());
        return 2 * new Vec3(apart.x(), apart.y(), apart.z()).norm();
    }

    private Vec3 velocity(BodyCurve of, double t, double h) {
        return position(of, t + h).minus(position(of, t - h)).times(0.5 / h);
    }

    private Vec3 acceleration(BodyCurve of, double t, double h) {
        double inside = Math.min(Math.max(t, h), 1 - h);
        Vec3 sum = position(of, inside + h).plus(position(of, inside - h));
        return sum.minus(position(of, inside).times(2)).times(1 / (h * h));
    }

    private Vec3 position(BodyCurve of, double t) {
        of.poseAt(t, pose);
        return pose.position();
    }

    private Vec3 secondDifference(BodyCurve of, Vec3 point, double t, double h) {
        of.poseAt(t + h, pose);
        Vec3 next = pose.orientation().rotate(point);
        of.poseAt(t - h, pose);
        Vec3 last = pose.orientation().rotate(point);
        of.poseAt(t, pose);
        Vec3 now = pose.orientation().rotate(point);
        return next.plus(last).minus(now.times(2)).times(1 / (h * h));
    }

    /** The least or greatest component along n of the points. */
    private static double along(double[] points, Vec3 n, boolean greatest) {
        double extreme = greatest ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
        for (int i = 0; i < points.length; i += 3) {
            double along = n.dot(new Vec3(points[i], points[i + 1], points[i + 2]));
            extreme = greatest ? Math.max(extreme, along) : Math.min(extreme, along);
        }
        return extreme;
    }
}
