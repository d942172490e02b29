package org.auvsim.core.step;

import org.auvsim.core.contact.ContactSolver;
import org.auvsim.core.contact.RestitutionRule;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Manifold;

/**
 * Bodies that stay in contact for the rest of a frame. Those that hang together are an island, and
 * an island is solved as a whole: its bodies are integrated as if nothing held them; the impulses
 * that bring the velocities at the frame's end to what the contacts allow are spread over the rest
 * of the frame as constant forces, and the bodies are integrated again with these. A body at rest
 * feels no net force and stays to the bit.
 */
final class RestingContacts {
    /** The gap (m) that resting contacts keep open, as a share of the smaller bounding radius. */
    static final double MARGIN = 1e-5;

    /** A pair that stays together may part by this share of the smaller bounding radius. */
    private static final double HOP = 0.02;

    /** The share of a wrong gap that is mended in one frame. */
    private static final double MENDING = 0.2;

    /** Overlap is mended no faster than this many bounding radii a second. */
    private static final double FASTEST_MENDING = 0.5;

    /**
     * Contacts that approach slower than this (m/s), such as the last frame's rest of error, need
     * no impulse at once: the forces mend it.
     */
    private static final double SLOW = 2e-6;

    /** Contacts that part slower than this (m/s) do so as gaps are mended. */
    private static final double SLOW_PARTING = 1e-4;

    private static final double TOLERANCE = 1e-6;
    private static final int MOST_SWEEPS = 400;

    /** With sub-steps, each round leaves at most 0.6 of an error. */
    private static final int MOST_ROUNDS = 16;

    private final BodyState bodies;
    private final BodyTraits traits;
    private final Trajectories trajectories;
    private final Touch touch;
    private final ContactProblem problem;
    private final ContactMemory memory;
    private final HeldPairs held;
    private final Manifold manifold = new Manifold();
    private final ContactSolver impacts = ContactSolver.forImpacts();
    private final ContactSolver resting = ContactSolver.forResting(TOLERANCE, MOST_SWEEPS);
    private double[] endVelocities = new double[6];

    /** The velocities at the end if there were no contact forces, six numbers a body. */
    private double[] free = new double[6];

    private final double[] force = new double[6];
    private final double[] approaches = new double[2];
    private int[] firstPoint = new int[64];
    private double[] parting = new double[64];

    RestingContacts(
            Motion motion,
            BodyTraits traits,
            Trajectories trajectories,
            Touch touch,
            ContactProblem problem) {
        this.bodies = motion.bodies();
        this.traits = traits;
        this.trajectories = trajectories;
        this.touch = touch;
        this.problem = problem;
        this.memory = motion.memory();
        this.held = new HeldPairs(traits, trajectories.groups());
    }

    HeldPairs pairs() {
        return held;
    }

    /**
     * Holds a pair that touches, or will in this frame, if it is to rest: it meets so slowly that
     * it would not part again within the frame.
     *
     * @param length of the frame (s), at whose beginning the pair is
     */
    boolean holdIfResting(int a, int b, double length) {
        if (traits.arePlainBalls(a, b) && isFast(a, b)) {
            return false;
        }
        double reach = hop(a, b) + trajectories.paths().relativeWay(a, b);
        touch.find(a, b, reach, manifold);
        if (manifold.count == 0) {
            return false;
        }
        problem.clear();
        problem.add(a, b, manifold);
        double approach = problem.fastestApproach(0);
        double gap = Double.POSITIVE_INFINITY;
        double pressure = 0;
        for (int k = 0; k < manifold.count; k++) {
            gap = Math.min(gap, Math.max(manifold.gap[k], 0));
            pressure = Math.max(pressure, pressure(a, b, 0, k));
        }
        double limit = limit(a, b, pressure, length);
        double impact = Math.sqrt(approach * approach + 2 * pressure * gap);
        if (restitution(a, b) * impact >= limit || approach < -limit) {
            return false;
        }
        held.hold(a, b, reach, limit);
        return true;
    }

    /** Tells most pairs of balls that bounce without looking at their contact. */
    private boolean isFast(int a, int b) {
        trajectories.paths().approaches(a, b, approaches);
        double pressure = Math.max(0, approaches[1] - approaches[0]);
        return restitution(a, b) * approaches[0] >= limit(a, b, pressure, 1);
    }

    /** Holds a pair that has met and is to stay together, even if it should part a little. */
    void stay(int a, int b, double limit) {
        held.hold(a, b, hop(a, b), limit);
    }

    private double hop(int a, int b) {
        return HOP * Math.min(traits.radius[a], traits.radius[b]);
    }

    private double pressure(int a, int b, double offset, int k) {
        return trajectories
                .paths()
                .pressure(a, b, offset, manifold.nx[k], manifold.ny[k], manifold.nz[k]);
    }

    /**
     * The speed (m/s) below which a pair does not part: that of its {@link RestitutionRule}, and
     * that of a hop which would be over within one frame, as the pair is pressed together. A pair
     * without loss bounces all the same.
     */
    double limit(int a, int b, double pressure, double length) {
        double e = restitution(a, b);
        double rest = RestitutionRule.of(e).restSpeed();
        return e < 1 ? Math.max(rest, pressure * length / 2) : rest;
    }

    /** The same for two that meet at an offset. */
    double limitAt(int a, int b, double offset, double length) {
        if (restitution(a, b) == 1) {
            return limit(a, b, 0, length);
        }
        return limit(a, b, Math.max(0, trajectories.paths().pressure(a, b, offset)), length);
    }

    private double restitution(int a, int b) {
        return Math.min(traits.restitution[a], traits.restitution[b]);
    }

    /**
     * Moves the island on from an offset: its bodies, which have been found in {@link #pairs}, get
     * new segments on which they stay in contact.
     *
     * @param length of the frame (s)
     */
    void settle(double offset, double length, double time) {
        int[] members = held.members();
        int count = held.memberCount();
        problem.clear();
        trajectories.moveTo(members, count, offset);
        for (int k = 0; k < count; k++) {
            trajectories.forces().clear(members[k]);
            problem.body(members[k]);
        }
        gatherContacts();
        if (endVelocities.length < 6 * count) {
            endVelocities = new double[12 * count];
            free = new double[12 * count];
        }
        boolean mayEndEarly = trajectories.mayEndEarly();
        double end = length;
        if (mayEndEarly) {
            end = trajectories.restartTogether(members, count, offset, end, endVelocities);
        }
        boolean isHit = aimAtImpact(end - offset);
        if (isHit) {
            impacts.solve(problem.bodies, problem.contacts);
            problem.applyImpulses();
        }
        noteParting();
        if (isHit || !mayEndEarly) {
            end = trajectories.restartTogether(members, count, offset, end, endVelocities);
        }
        double reached = problem.contacts.count == 0 ? end : hold(offset, end, time);
        while (reached < end) {
            end = reached;
            clearForces(count);
            trajectories.restartTogether(members, count, offset, end, endVelocities);
            reached = hold(offset, end, time);
        }
    }

    private void clearForces(int count) {
        for (int k = 0; k < count; k++) {
            trajectories.forces().clear(held.members()[k]);
        }
    }

    /** The points of all held pairs; those that would bounce, or no longer touch, are let go. */
    private void gatherContacts() {
        int[] pairs = held.pairs();
        if (firstPoint.length <= held.pairCount()) {
            firstPoint = new int[2 * held.pairCount() + 1];
        }
        for (int k = 0; k < held.pairCount(); k++) {
            int a = held.first(pairs[k]);
            int b = held.second(pairs[k]);
            int before = problem.contacts.count;
            firstPoint[k] = before;
            touch.find(a, b, held.reach(pairs[k]), manifold);
            problem.add(a, b, manifold);
            double parting = restitution(a, b) * approach(before, traits.nearness(a, b));
            if (manifold.count == 0 || parting >= held.limit(pairs[k])) {
                held.release(pairs[k]);
                problem.contacts.count = before;
            }
        }
        firstPoint[held.pairCount()] = problem.contacts.count;
    }

    /**
     * How fast (m/s) a pair approaches where it touches. While one corner stands, another that
     * comes down rests as well: let go, the corner that stands would meet again at once, without
     * end.
     */
    private double approach(int from, double nearness) {
        double fastest = Double.NEGATIVE_INFINITY;
        for (int c = from; c < problem.contacts.count; c++) {
            if (problem.gap(c) <= nearness) {
                double closing = -problem.contacts.separationSpeed(c, problem.bodies);
                fastest = Math.max(fastest, closing);
            }
        }
        return fastest > Double.NEGATIVE_INFINITY ? fastest : problem.fastestApproach(from);
    }

    /** Notes how fast the bodies part at each contact as the segment begins. */
    private void noteParting() {
        if (parting.length < problem.contacts.count) {
            parting = new double[2 * problem.contacts.count];
        }
        for (int c = 0; c < problem.contacts.count; c++) {
            parting[c] = problem.contacts.separationSpeed(c, problem.bodies);
        }
    }

    /**
     * Asks of each contact that the bodies do not meet within {@code h} (s) at their present
     * speeds; false if they do not.
     */
    private boolean aimAtImpact(double h) {
        boolean any = false;
        for (int k = 0; k < held.pairCount(); k++) {
            double margin = margin(k);
            for (int c = firstPoint[k]; c < firstPoint[k + 1]; c++) {
                double target = Math.min(0, (margin - problem.gap(c)) / h);
                problem.contacts.target[c] = target;
                any |= problem.contacts.separationSpeed(c, problem.bodies) < target - SLOW;
            }
        }
        return any;
    }

    private double margin(int k) {
        int pair = held.pairs()[k];
        return traits.nearness(held.first(pair), held.second(pair)) / 2;
    }

    /**
     * Puts the contact forces on the island that hold it up to {@code end}. Where forces depend on
     * how bodies move, an impulse does not change the end as much as an impact would: what is
     * missing is solved for again, with the velocities that the forces so far have left.
     *
     * @return the offset up to which it could be integrated
     */
    private double hold(double offset, double end, double time) {
        double h = end - offset;
        int count = held.memberCount();
        System.arraycopy(endVelocities, 0, free, 0, 6 * count);
        for (int k = 0; k < held.pairCount(); k++) {
            aim(k, h, time);
        }
        double reached = end;
        boolean isDone = false;
        for (int round = 0; !isDone && round < MOST_ROUNDS; round++) {
            boolean any = push(h, time, count);
            if (any || round > 0) {
                reached =
                        trajectories.restartTogether(
                                held.members(), count, offset, end, endVelocities);
            }
            isDone = !any || reached < end || !trajectories.mayEndEarly() || isAsSolved(count);
        }
        return reached;
    }

    /** Whether the bodies end as fast as solved for; if not, notes what is missing. */
    private boolean isAsSolved(int count) {
        double worst = 0;
        for (int k = 0; k < 6 * count; k++) {
            double missing = endVelocities[k] - problem.bodies.v[k];
            free[k] += missing;
            worst = Math.max(worst, Math.abs(missing));
        }
        return worst <= TOLERANCE;
    }

    /** Solves for the contact forces over {@code h} (s) and sets them; false if there are none. */
    private boolean push(double h, double time, int count) {
        for (int k = 0; k < count; k++) {
            problem.setVelocity(k, free, 6 * k);
        }
        resting.solve(problem.bodies, problem.contacts);
        for (int k = 0; k < held.pairCount(); k++) {
            remember(k, h, time);
        }
        boolean any = false;
        for (int k = 0; k < count; k++) {
            any |= setForce(k, h);
        }
        return any;
    }

    /** Sets what the contacts of a pair are to reach, and the solver's first guess. */
    private void aim(int k, double h, double time) {
        int a = held.first(held.pairs()[k]);
        int b = held.second(held.pairs()[k]);
        int entry = memory.entry(Math.min(a, b), Math.max(a, b), time);
        double smaller = Math.min(traits.radius[a], traits.radius[b]);
        for (int c = firstPoint[k]; c < firstPoint[k + 1]; c++) {
            double missing = margin(k) - problem.gap(c);
            problem.contacts.target[c] =
                    missing < 0
                            ? missing / h
                            : Math.min(MENDING * missing / h, FASTEST_MENDING * smaller);
            if (parting[c] > SLOW_PARTING) {
                // What parts at first comes back as fast at most: so the force does no work.
                problem.contacts.target[c] = Math.min(problem.contacts.target[c], -parting[c]);
            }
            Vec3 place = onBody(Math.min(a, b), c);
            int found = memory.nearest(entry, place.x(), place.y(), place.z(), 0.05 * smaller);
            if (found >= 0) {
                double sign = a < b ? h : -h;
                problem.contacts.guess(
                        c,
                        h * memory.force(found),
                        sign * memory.force(found + 1),
                        sign * memory.force(found + 2),
                        sign * memory.force(found + 3));
            } else {
                problem.contacts.guess(c, 0, 0, 0, 0);
            }
        }
    }

    private void remember(int k, double h, double time) {
        int a = held.first(held.pairs()[k]);
        int b = held.second(held.pairs()[k]);
        int entry = memory.entry(Math.min(a, b), Math.max(a, b), time);
        double sign = a < b ? 1 / h : -1 / h;
        memory.clearPoints(entry);
        for (int c = firstPoint[k]; c < firstPoint[k + 1]; c++) {
            Vec3 place = onBody(Math.min(a, b), c);
            memory.addPoint(
                    entry,
                    place.x(),
                    place.y(),
                    place.z(),
                    problem.contacts.jn[c] / h,
                    sign * problem.contacts.jx[c],
                    sign * problem.contacts.jy[c],
                    sign * problem.contacts.jz[c]);
        }
    }

    /** A contact's place (m) in the axes of a body. */
    private Vec3 onBody(int slot, int c) {
        Quat turn =
                new Quat(
                        bodies.column(BodyState.QW)[slot],
                        bodies.column(BodyState.QX)[slot],
                        bodies.column(BodyState.QY)[slot],
                        bodies.column(BodyState.QZ)[slot]);
        return turn.rotateInverse(
                new Vec3(
                        problem.contacts.px[c] - bodies.column(BodyState.X)[slot],
                        problem.contacts.py[c] - bodies.column(BodyState.Y)[slot],
                        problem.contacts.pz[c] - bodies.column(BodyState.Z)[slot]));
    }

    private boolean setForce(int body, double h) {
        int slot = problem.slot(body);
        // A ball without friction is not turned, not even by rounding.
        int kept = traits.isBall[slot] && traits.friction[slot] == 0 ? 3 : 6;
        boolean any = false;
        for (int c = 0; c < 6; c++) {
            force[c] = c < kept ? problem.bodies.impulse[6 * body + c] / h : 0;
            any |= force[c] != 0;
        }
        if (any) {
            trajectories.forces().set(slot, force, 0);
        }
        return any;
    }
}
