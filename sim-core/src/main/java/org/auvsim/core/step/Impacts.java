package org.auvsim.core.step;

import org.auvsim.core.contact.Bounce;
import org.auvsim.core.contact.ContactSolver;
import org.auvsim.core.contact.RestitutionRule;
import org.auvsim.core.contact.Solution;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Manifold;

/** What two bodies do that meet: the impulse that parts them, or the decision that they stay. */
final class Impacts {
    /** Bodies that approach slower than this (m/s) do so by rounding only. */
    private static final double APPROACH_TOLERANCE = 1e-10;

    private final BodyState bodies;
    private final BodyTraits traits;
    private final Touch touch;
    private final ContactProblem problem;
    private final ContactMemory memory;
    private final StepTally tally;
    private final Manifold manifold = new Manifold();
    private final ContactSolver solver = ContactSolver.forImpacts();
    private Vec3 impulse = Vec3.ZERO;

    Impacts(Motion motion, BodyTraits traits, Touch touch, ContactProblem problem) {
        this.bodies = motion.bodies();
        this.traits = traits;
        this.touch = touch;
        this.problem = problem;
        this.memory = motion.memory();
        this.tally = motion.tally();
    }

    /** How a meeting ended. */
    enum Outcome {
        /** The two part already: nothing has happened. */
        PARTED,
        /** They neither part nor meet, but are pressed together: nothing has happened yet. */
        PRESSED,
        /** They part now. */
        BOUNCED,
        /** They are to stay together. */
        STAY
    }

    /**
     * Lets two bodies meet that touch now.
     *
     * @param time of the world (s)
     * @param limit below this speed (m/s) the two do not part
     * @param wantsImpulse whether {@link #impulse} will be asked for
     */
    Outcome meet(int a, int b, double time, double limit, boolean wantsImpulse) {
        return traits.arePlainBalls(a, b)
                ? meetBalls(a, b, time, limit, wantsImpulse)
                : meetShapes(a, b, time, limit, wantsImpulse);
    }

    /** Balls without friction: the closed form, as nothing turns. */
    private Outcome meetBalls(int a, int b, double time, double limit, boolean wantsImpulse) {
        double[] x = bodies.column(BodyState.X);
        double[] y = bodies.column(BodyState.Y);
        double[] z = bodies.column(BodyState.Z);
        double[] px = bodies.column(BodyState.PX);
        double[] py = bodies.column(BodyState.PY);
        double[] pz = bodies.column(BodyState.PZ);
        double ma = bodies.inverseMass()[a];
        double mb = bodies.inverseMass()[b];
        double nx = x[a] - x[b];
        double ny = y[a] - y[b];
        double nz = z[a] - z[b];
        double k = 1 / Math.sqrt(nx * nx + ny * ny + nz * nz);
        double approach =
                -k
                        * (nx * (px[a] * ma - px[b] * mb)
                                + ny * (py[a] * ma - py[b] * mb)
                                + nz * (pz[a] * ma - pz[b] * mb));
        if (approach <= APPROACH_TOLERANCE) {
            return withoutApproach(approach);
        }
        double e = restitution(a, b, approach, time, limit);
        double j = (1 + Math.max(e, 0)) * approach / (ma + mb) * k;
        double jx = j * nx;
        double jy = j * ny;
        double jz = j * nz;
        if (ma > 0) {
            px[a] += jx;
            py[a] += jy;
            pz[a] += jz;
        }
        if (mb > 0) {
            px[b] -= jx;
            py[b] -= jy;
            pz[b] -= jz;
        }
        if (wantsImpulse) {
            impulse = new Vec3(jx, jy, jz);
        }
        return e < 0 ? Outcome.STAY : Outcome.BOUNCED;
    }

    private Outcome meetShapes(int a, int b, double time, double limit, boolean wantsImpulse) {
        problem.clear();
        touch.find(a, b, traits.nearness(a, b), manifold);
        problem.add(a, b, manifold);
        if (manifold.count == 0) {
            return Outcome.PARTED;
        }
        double approach = problem.fastestApproach(0);
        if (approach <= APPROACH_TOLERANCE) {
            return withoutApproach(approach);
        }
        double e = restitution(a, b, approach, time, limit);
        for (int c = 0; c < problem.contacts.count; c++) {
            double closing = -problem.contacts.separationSpeed(c, problem.bodies);
            problem.contacts.target[c] = Math.max(e, 0) * Math.max(closing, 0);
        }
        Solution solution = solver.solve(problem.bodies, problem.contacts);
        tally.loweredHits += solution.bounceKept() < 1 ? 1 : 0;
        tally.unsolvedIslands += solution.converged() ? 0 : 1;
        problem.applyImpulses();
        if (wantsImpulse) {
            double[] received = problem.bodies.impulse;
            int at = 6 * problem.body(a);
            impulse = new Vec3(received[at], received[at + 1], received[at + 2]);
        }
        return e < 0 ? Outcome.STAY : Outcome.BOUNCED;
    }

    private static Outcome withoutApproach(double approach) {
        return approach < -APPROACH_TOLERANCE ? Outcome.PARTED : Outcome.PRESSED;
    }

    /** The restitution of this meeting; -1 if the two are to stay together. */
    private double restitution(int a, int b, double approach, double time, double limit) {
        double e = Math.min(traits.restitution[a], traits.restitution[b]);
        RestitutionRule rule = RestitutionRule.of(e);
        if (e * approach < limit) {
            return -1;
        }
        if (e == 1) {
            // Nothing has to be remembered of what never comes to rest.
            return 1;
        }
        int entry = memory.entry(Math.min(a, b), Math.max(a, b), time);
        int repeats = rule.repeats(time - memory.lastHit(entry), memory.repeats(entry));
        memory.hit(entry, time, repeats);
        Bounce bounce = rule.decide(approach, e, repeats);
        return switch (bounce) {
            case RESTITUTION -> e;
            case ELASTIC_IN_CONTACT_TIME -> {
                tally.quickHits++;
                yield 1;
            }
            case REST_AS_SLOW, REST_AS_REPEATED -> -1;
        };
    }

    /** What the first body of the last meeting received (N s, world), if it was wanted. */
    Vec3 impulse() {
        return impulse;
    }
}
