package org.auvsim.core.contact;

import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;

/**
 * A plain stepper for resting contacts: semi-implicit Euler with the speeds of a {@link
 * ContactSolver}. Body 0 is the ground and stands still.
 */
final class Settling {
    static final double GRAVITY = 9.81;

    /** Share of an overlap that a step takes away, and what it leaves be (m). */
    private static final double PUSH = 0.2;

    private static final double SLOP = 1e-5;
    private static final double REACH = 0.02;

    final double dt;
    final ContactSolver solver;
    final ContactBodies bodies = new ContactBodies();
    final Contacts contacts = new Contacts();
    final List<Body> list = new ArrayList<>();
    Vec3 gravity = new Vec3(0, 0, -GRAVITY);
    double friction = 0.5;
    private Map<Long, double[]> last = new HashMap<>();
    private Map<Long, double[]> next = new HashMap<>();

    Settling(double dt, ContactSolver solver) {
        this.dt = dt;
        this.solver = solver;
        list.add(new Body(Vec3.ZERO, Double.POSITIVE_INFINITY, Vec3.ZERO));
    }

    /** A body; its half extents are those of a box, or all the radius of a ball. */
    static final class Body {
        Vec3 x;
        Quat q = Quat.IDENTITY;
        Vec3 v = Vec3.ZERO;
        Vec3 w = Vec3.ZERO;
        final double mass;
        final Vec3 half;
        Vec3 inertia = Vec3.ZERO;

        Body(Vec3 x, double mass, Vec3 half) {
            this.x = x;
            this.mass = mass;
            this.half = half;
        }

        Vec3 corner(int i) {
            return x.plus(
                    q.rotate(
                            new Vec3(
                                    (i & 1) == 0 ? -half.x() : half.x(),
                                    (i & 2) == 0 ? -half.y() : half.y(),
                                    (i & 4) == 0 ? -half.z() : half.z())));
        }
    }

    Body box(Vec3 x, double mass, Vec3 half) {
        Body body = new Body(x, mass, half);
        Vec3 h = new Vec3(half.x() * half.x(), half.y() * half.y(), half.z() * half.z());
        body.inertia = new Vec3(h.y() + h.z(), h.x() + h.z(), h.x() + h.y()).times(body.mass / 3);
        list.add(body);
        return body;
    }

    Body ball(Vec3 x, double mass, double radius) {
        Body body = new Body(x, mass, new Vec3(radius, radius, radius));
        body.inertia = new Vec3(1, 1, 1).times(0.4 * mass * radius * radius);
        list.add(body);
        return body;
    }

    /** One step; {@code touch} says what touches body i, by calls of {@link #contact}. */
    void step(IntFunction<Runnable> touch) {
        bodies.clear();
        contacts.clear();
        next.clear();
        list.forEach(this::load);
        for (int i = 1; i < list.size(); i++) {
            touch.apply(i).run();
        }
        solver.solve(bodies, contacts);
        Map<Long, double[]> of = last;
        for (Map.Entry<Long, double[]> entry : next.entrySet()) {
            int c = (int) entry.getValue()[0];
            entry.setValue(
                    new double[] {contacts.jn[c], contacts.jx[c], contacts.jy[c], contacts.jz[c]});
        }
        last = next;
        next = of;
        for (int i = 1; i < list.size(); i++) {
            advance(i);
        }
    }

    private void load(Body body) {
        int i = bodies.add(body.x.x(), body.x.y(), body.x.z());
        if (!(body.mass < Double.POSITIVE_INFINITY)) {
            return;
        }
        Vec3 v = body.v.plus(gravity.times(dt));
        double[] speeds = {v.x(), v.y(), v.z(), body.w.x(), body.w.y(), body.w.z()};
        System.arraycopy(speeds, 0, bodies.v, 6 * i, 6);
        Mat3 turn = turn(body.q);
        Mat3 k =
                turn.times(
                                Mat3.diagonal(
                                        1 / body.inertia.x(),
                                        1 / body.inertia.y(),
                                        1 / body.inertia.z()))
                        .times(turn.transposed());
        double[] angular = {k.xx(), k.xy(), k.xz(), k.yx(), k.yy(), k.yz(), k.zx(), k.zy(), k.zz()};
        for (int r = 0; r < 3; r++) {
            bodies.k[36 * i + 7 * r] = 1 / body.mass;
            System.arraycopy(angular, 3 * r, bodies.k, 36 * i + 6 * (r + 3) + 3, 3);
        }
    }

    private static Mat3 turn(Quat q) {
        Vec3 x = q.rotate(new Vec3(1, 0, 0));
        Vec3 y = q.rotate(new Vec3(0, 1, 0));
        Vec3 z = q.rotate(new Vec3(0, 0, 1));
        return new Mat3(x.x(), y.x(), z.x(), x.y(), y.y(), z.y(), x.z(), y.z(), z.z());
    }

    /** Body a on body b, with the normal from b to a; far ones are left out. */
    void contact(int a, int b, int feature, Vec3 p, Vec3 n, double gap) {
        if (gap > REACH) {
            return;
        }
        int c = contacts.add(a, b, p.x(), p.y(), p.z(), n.x(), n.y(), n.z());
        contacts.friction[c] = friction;
        contacts.target[c] =
                gap > 0 ? -gap / dt : Math.min(1, PUSH * Math.max(0, -gap - SLOP) / dt);
        long key = ((long) a * 100_000 + b) * 100 + feature;
        double[] guess = last.get(key);
        if (guess != null) {
            contacts.guess(c, guess[0], guess[1], guess[2], guess[3]);
        }
        next.put(key, new double[] {c});
    }

    /** The lower corners of a box on a plane that belongs to body b. */
    void corners(int a, int b, Vec3 on, Vec3 n) {
        Body box = list.get(a);
        for (int i = 0; i < 8; i++) {
            if (box.corner(i).minus(box.x).dot(n) < 0) {
                double gap = box.corner(i).minus(on).dot(n);
                contact(a, b, i, box.corner(i).minus(n.times(gap / 2)), n, gap);
            }
        }
    }

    /** A ball on a plane of the ground. */
    void ballOn(int a, int plane, Vec3 on, Vec3 n) {
        Body ball = list.get(a);
        double gap = ball.x.minus(on).dot(n) - ball.half.x();
        contact(a, 0, plane, ball.x.minus(n.times(ball.half.x() + gap / 2)), n, gap);
    }

    /** A ball on all balls before it. */
    void ballOnBalls(int a) {
        Body ball = list.get(a);
        for (int b = 1; b < a; b++) {
            Body other = list.get(b);
            Vec3 apart = ball.x.minus(other.x);
            double reach = ball.half.x() + other.half.x();
            if (apart.norm() < reach + REACH) {
                Vec3 n = apart.normalized();
                double gap = apart.norm() - reach;
                contact(a, b, 0, other.x.plus(n.times(other.half.x() + gap / 2)), n, gap);
            }
        }
    }

    private void advance(int i) {
        Body body = list.get(i);
        double[] v = bodies.v;
        body.v = new Vec3(v[6 * i], v[6 * i + 1], v[6 * i + 2]);
        body.w = new Vec3(v[6 * i + 3], v[6 * i + 4], v[6 * i + 5]);
        body.x = body.x.plus(body.v.times(dt));
        Vec3 half = body.w.times(dt / 2);
        body.q = new Quat(1, half.x(), half.y(), half.z()).times(body.q).normalized();
    }

    /** Root mean square of the speeds (m/s); a single ball may roll or spin for ever. */
    double speed() {
        double squares = list.stream().mapToDouble(b -> b.v.dot(b.v)).sum();
        return Math.sqrt(squares / list.size());
    }
}
