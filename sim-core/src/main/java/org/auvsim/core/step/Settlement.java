package org.auvsim.core.step;

import org.auvsim.core.contact.ContactSolver;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.volume.Manifold;
import org.auvsim.core.volume.Pose;

import java.util.Arrays;

/**
 * Brings an island of bodies in contact over one segment of time. First impulses end what
 * approaches too fast to stay apart. Then the constant forces are sought under which all contacts
 * stay open at the segment's end: the bodies are traced with the forces of last time, the contacts
 * are looked up where this trial has the bodies halfway, and the forces are solved for that change
 * the trial's end to what is wanted; until a trial ends as solved for. Contacts taken halfway make
 * the forces' work right to the third order of the time (the midpoint rule), so that what turns
 * gains no energy; where that is not enough the segment is halved.
 *
 * <p>A body at rest feels no net force and stays to the bit.
 */
final class Settlement {
    /** The share of a wrong gap that is mended in one segment. */
    private static final double MENDING = 0.2;

    /** Overlap is mended no faster than this many bounding radii a second. */
    private static final double FASTEST_MENDING = 0.5;

    /** The share of the margin that has to be left at a segment's end. */
    private static final double LEAST_GAP = 0.5;

    /**
     * Contacts that approach slower than this (m/s), such as the last frame's rest of error, need
     * no impulse at once: the forces mend it.
     */
    private static final double SLOW = 2e-6;

    /** Contacts that part slower than this (m/s) do so as gaps are mended. */
    private static final double SLOW_PARTING = 1e-4;

    /** How well what approaches is stopped (m/s): the forces mend the rest. */
    private static final double STOP_TOLERANCE = 1e-6;

    /** How well the forces are solved for (m/s): stacks amplify errors. */
    private static final double TOLERANCE = 1e-6;

    /** The same within a frame, and for balls without friction, which only have to stay apart. */
    private static final double ROUGH = 1e-5;

    /** How well speeds are solved for, as a share of the fastest. */
    private static final double SHARE_OF_SPEED = 0.01;

    private static final int MOST_SWEEPS = 400;
    private static final int MOST_ROUNDS = 12;

    /** Contacts may do this share of the bodies' energy as work in a segment: rounding and more. */
    private static final double WORK_TOLERANCE = 1e-7;

    /** The share of the margin by which gaps may open without being noticed. */
    private static final double SLACK = 0.02;

    /** No frame is cut into more segments than this to keep contacts from doing work. */
    private static final int MOST_PARTS = 64;

    private final BodyState bodies;
    private final BodyTraits traits;
    private final Trajectories trajectories;
    private final Touch touch;
    private final ContactProblem problem;
    private final ContactMemory memory;
    private final RestingContacts resting;
    private final HeldPairs held;
    private final Manifold manifold = new Manifold();
    private final BodyCurve curve = new BodyCurve();
    private final Pose pose = new Pose();
    private final Pose other = new Pose();
    private final ContactSolver stops = ContactSolver.forResting(STOP_TOLERANCE, MOST_SWEEPS);
    private final ContactSolver forces = ContactSolver.forResting(TOLERANCE, MOST_SWEEPS);
    private final ContactSolver rough = ContactSolver.forResting(ROUGH, MOST_SWEEPS);

    /** Velocities where the segment starts and where the trial ends: six numbers a body. */
    private double[] startVelocity = new double[6];

    private double[] endVelocity = new double[6];

    /** How far each body moves from start to middle, and from there to the trial's end. */
    private double[] toMiddle = new double[6];

    private double[] toEnd = new double[6];

    /** The contact forces (N) and torques (N m) of the trial: six numbers a body. */
    private double[] applied = new double[6];

    /** Whether the segment begins within a frame: errors do not add up from frame to frame. */
    private boolean isPassing;

    private final double[] spin = new double[3];
    private final double[] place = new double[3];
    private int[] firstPoint = new int[64];
    private int[] entry = new int[64];

    /** Numbers a contact at the start: its place on the body (m), the bodies' slip (m/s). */
    private static final int START = 6;

    private double[] startContacts = new double[START * 64];
    private int[] firstStart = new int[64];
    private double[] startGap = new double[64];
    private final double[] slip = new double[3];
    private double[] predicted = new double[64];
    private double[] cap = new double[64];
    private double[] trialSpeed = new double[64];
    private double[] before = new double[64];

    Settlement(
            Motion motion,
            BodyTraits traits,
            Trajectories trajectories,
            Touch touch,
            ContactProblem problem,
            RestingContacts resting) {
        this.bodies = motion.bodies();
        this.traits = traits;
        this.trajectories = trajectories;
        this.touch = touch;
        this.problem = problem;
        this.memory = motion.memory();
        this.resting = resting;
        this.held = resting.pairs();
    }

    /**
     * Gives the island's bodies, which have been found in {@link RestingContacts#pairs}, new
     * segments from an offset on, on which they stay in contact.
     *
     * @param length of the frame (s)
     * @param time of the world (s) at the offset
     */
    void settle(double offset, double length, double time) {
        int[] members = held.members();
        int count = held.memberCount();
        reserve(count);
        isPassing = offset > 0;
        trajectories.moveTo(members, count, offset);
        problem.clear();
        for (int k = 0; k < count; k++) {
            paths().pose(members[k], pose);
            problem.place(members[k], pose);
        }
        trajectories.velocitiesNow(members, count, startVelocity);
        problem.setVelocities(count, startVelocity);
        gatherContacts();
        if (aimAtImpact(length - offset)) {
            stops.solve(problem.bodies, problem.contacts);
            problem.applyImpulses();
            System.arraycopy(problem.bodies.v, 0, startVelocity, 0, 6 * count);
        }
        boolean holds = problem.contacts.count > 0;
        noteStart();
        findEntries(time);
        setRemembered(length - offset);
        double end = trace(offset, length);
        while (holds) {
            double reached = hold(offset, end, length);
            if (reached == end) {
                return;
            }
            end = trace(offset, reached);
        }
    }

    private void reserve(int count) {
        if (startVelocity.length < 6 * count) {
            startVelocity = new double[12 * count];
            endVelocity = new double[12 * count];
            toMiddle = new double[12 * count];
            toEnd = new double[12 * count];
            applied = new double[12 * count];
        }
    }

    private Paths paths() {
        return trajectories.paths();
    }

    private double trace(double from, double to) {
        return trajectories.restartTogether(
                held.members(), held.memberCount(), from, to, endVelocity);
    }

    /** The points of all held pairs; those that would bounce, or no longer touch, are let go. */
    private void gatherContacts() {
        int[] pairs = held.pairs();
        if (firstPoint.length <= held.pairCount()) {
            firstPoint = new int[2 * held.pairCount() + 1];
            entry = new int[2 * held.pairCount() + 1];
            firstStart = new int[2 * held.pairCount() + 1];
            startGap = new double[2 * held.pairCount() + 1];
        }
        for (int k = 0; k < held.pairCount(); k++) {
            int a = held.first(pairs[k]);
            int b = held.second(pairs[k]);
            int before = problem.contacts.count;
            firstPoint[k] = before;
            touch.find(a, b, held.reach(pairs[k]), manifold);
            problem.add(a, b, manifold);
            double parting = resting.restitution(a, b) * approach(before, traits.nearness(a, b));
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

    /**
     * How well (m/s, rad/s) a trial has to end as solved for: so that gaps stay open, and better
     * the slower the bodies are.
     */
    private double near(double h) {
        double fastest = 0;
        for (int k = 0; k < 6 * held.memberCount(); k++) {
            fastest = Math.max(fastest, Math.abs(endVelocity[k]));
        }
        double open = LEAST_GAP * leastMargin() / h;
        return Math.min(open, Math.max(TOLERANCE, SHARE_OF_SPEED * fastest));
    }

    private double leastMargin() {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < held.pairCount(); k++) {
            least = Math.min(least, margin(k));
        }
        return least;
    }

    private double margin(int k) {
        int pair = held.pairs()[k];
        return traits.nearness(held.first(pair), held.second(pair)) / 2;
    }

    /** Notes where the contacts are as the segment starts, and how the bodies slip there. */
    private void noteStart() {
        int count = problem.contacts.count;
        if (startContacts.length < START * count) {
            startContacts = new double[2 * START * count];
        }
        System.arraycopy(firstPoint, 0, firstStart, 0, held.pairCount() + 1);
        for (int k = 0; paths().turn() && k < held.pairCount(); k++) {
            int slot = placeBody(k);
            startGap[k] = Double.POSITIVE_INFINITY;
            for (int c = firstPoint[k]; c < firstPoint[k + 1]; c++) {
                startGap[k] = Math.min(startGap[k], problem.gap(c));
                findPlace(slot, c);
                System.arraycopy(place, 0, startContacts, START * c, 3);
                problem.contacts.slipNow(c, problem.bodies, startContacts, START * c + 3);
            }
        }
    }

    /**
     * With contacts taken halfway, what does not slip at the start seems to, and as much the other
     * way round at the end: so much is no slip.
     */
    private void excuseTurning() {
        for (int k = 0; paths().turn() && k < held.pairCount(); k++) {
            int slot = placeBody(k);
            for (int c = firstPoint[k]; c < firstPoint[k + 1]; c++) {
                int start = nearestStart(k, slot, c);
                if (start >= 0) {
                    problem.contacts.slipNow(c, problem.bodies, slip, 0);
                    problem.contacts.slip(
                            c,
                            startContacts[start + 3] - slip[0],
                            startContacts[start + 4] - slip[1],
                            startContacts[start + 5] - slip[2]);
                }
            }
        }
    }

    /** Where the contact of a pair is noted that was nearest to this one on the body; -1: none. */
    private int nearestStart(int k, int slot, int c) {
        findPlace(slot, c);
        int best = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int s = firstStart[k]; s < firstStart[k + 1]; s++) {
            double dx = startContacts[START * s] - place[0];
            double dy = startContacts[START * s + 1] - place[1];
            double dz = startContacts[START * s + 2] - place[2];
            double squared = dx * dx + dy * dy + dz * dz;
            if (squared < least) {
                least = squared;
                best = START * s;
            }
        }
        return best;
    }

    /** The body of a pair in whose axes contacts are remembered. */
    private int placeBody(int k) {
        return Math.min(held.first(held.pairs()[k]), held.second(held.pairs()[k]));
    }

    /** What the world remembers of each pair; an entry that is made may move others. */
    private void findEntries(double time) {
        for (int round = 0; round < 2; round++) {
            for (int k = 0; k < held.pairCount(); k++) {
                int a = held.first(held.pairs()[k]);
                int b = held.second(held.pairs()[k]);
                entry[k] = memory.entry(Math.min(a, b), Math.max(a, b), time);
            }
        }
    }

    /** Starts with the forces that the contacts had last time. */
    private void setRemembered(double h) {
        Arrays.fill(problem.bodies.impulse, 0, 6 * problem.bodies.count, 0);
        if (problem.contacts.count > 0) {
            guess(h);
            forces.sum(problem.bodies, problem.contacts);
        }
        setForces(h);
    }

    /**
     * Finds the contact forces under which the island stays apart up to {@code end}.
     *
     * @return that offset, or the earlier one at which the segment has to end
     */
    private double hold(double offset, double end, double length) {
        double h = end - offset;
        int count = held.memberCount();
        double change = Double.POSITIVE_INFINITY;
        double near = near(h);
        for (int round = 0; change > near && round < MOST_ROUNDS; round++) {
            findContacts(h);
            change = solve(h);
            setForces(h);
            double reached = trace(offset, end);
            if (reached < end) {
                return reached;
            }
        }
        boolean isLong = h * MOST_PARTS > length;
        return isLong && paths().turn() && doesWork(h, count) ? offset + h / 2 : end;
    }

    /** The contacts where the trial has the bodies halfway, and what to reach there. */
    private void findContacts(double h) {
        int count = held.memberCount();
        problem.clear();
        for (int k = 0; k < count; k++) {
            place(k);
        }
        for (int k = 0; k < held.pairCount(); k++) {
            int a = held.first(held.pairs()[k]);
            int b = held.second(held.pairs()[k]);
            firstPoint[k] = problem.contacts.count;
            if (!held.isHeld(held.pairs()[k])) {
                continue;
            }
            paths().middle(a, curve, pose);
            paths().middle(b, curve, other);
            double reach =
                    areSpheres(k) ? Double.POSITIVE_INFINITY : 2 * held.reach(held.pairs()[k]);
            touch.find(a, pose, b, other, reach, manifold);
            problem.add(a, b, manifold);
        }
        firstPoint[held.pairCount()] = problem.contacts.count;
        if (predicted.length < problem.contacts.count) {
            predicted = new double[2 * problem.contacts.count];
            cap = new double[2 * problem.contacts.count];
            trialSpeed = new double[2 * problem.contacts.count];
            before = new double[2 * problem.contacts.count];
        }
        aim(h);
        guess(h);
        for (int k = 0; k < count; k++) {
            problem.setFree(k, endVelocity, applied, h);
        }
    }

    /** Places a member where it is halfway, and notes how it gets there and on. */
    private void place(int k) {
        int slot = held.members()[k];
        paths().middle(slot, curve, pose);
        problem.place(slot, pose);
        paths().pose(slot, other);
        noteWay(other, pose, toMiddle, 6 * k);
        boolean turns = !traits.isPlainBall(slot);
        if (turns) {
            noteTurn(other, pose, toMiddle, 6 * k + 3);
        }
        paths().endPose(slot, other);
        noteWay(pose, other, toEnd, 6 * k);
        if (turns) {
            noteTurn(pose, other, toEnd, 6 * k + 3);
        }
    }

    private static void noteWay(Pose from, Pose to, double[] way, int at) {
        way[at] = to.x - from.x;
        way[at + 1] = to.y - from.y;
        way[at + 2] = to.z - from.z;
        way[at + 3] = 0;
        way[at + 4] = 0;
        way[at + 5] = 0;
    }

    /** The angles from one orientation to another (rad), taken for their sines. */
    private static void noteTurn(Pose from, Pose to, double[] turn, int at) {
        double w = to.qw * from.qw + to.qx * from.qx + to.qy * from.qy + to.qz * from.qz;
        double twice = w < 0 ? -2 : 2;
        double x = to.qx * from.qw - to.qw * from.qx - to.qy * from.qz + to.qz * from.qy;
        double y = to.qy * from.qw - to.qw * from.qy - to.qz * from.qx + to.qx * from.qz;
        double z = to.qz * from.qw - to.qw * from.qz - to.qx * from.qy + to.qy * from.qx;
        turn[at] = twice * x;
        turn[at + 1] = twice * y;
        turn[at + 2] = twice * z;
    }

    /** Sets the speeds that the contacts are to have at the end. */
    private void aim(double h) {
        int count = held.memberCount();
        problem.setVelocities(count, toMiddle);
        for (int c = 0; c < problem.contacts.count; c++) {
            before[c] = problem.gap(c) - speed(c);
        }
        problem.setVelocities(count, toEnd);
        for (int c = 0; c < problem.contacts.count; c++) {
            predicted[c] = problem.gap(c) + speed(c);
        }
        problem.setVelocities(count, startVelocity);
        excuseTurning();
        for (int k = 0; k < held.pairCount(); k++) {
            double margin = margin(k);
            double fastest = FASTEST_MENDING * smallerRadius(k);
            for (int c = firstPoint[k]; c < firstPoint[k + 1]; c++) {
                double missing = margin - before[c];
                double wanted =
                        missing < 0 ? missing / h : Math.min(MENDING * missing / h, fastest);
                double parting = speed(c);
                double overlap = Math.max(0, missing - (1 - LEAST_GAP) * margin);
                cap[c] =
                        areSpheres(k)
                                ? Double.POSITIVE_INFINITY
                                : Math.max(0, -parting) + Math.min(2 * overlap / h, fastest);
                if (parting > SLOW_PARTING) {
                    // What parts at first comes back as fast at most: so the force does no work.
                    wanted = Math.min(wanted, -parting);
                }
                problem.contacts.target[c] = wanted;
            }
        }
        problem.setVelocities(count, endVelocity);
        for (int k = 0; k < held.pairCount(); k++) {
            double bend = h / 2 * bend(k);
            double shift = bend * h > margin(k) / 100 ? shift(k) : 0;
            double fastest = FASTEST_MENDING * smallerRadius(k);
            for (int c = firstPoint[k]; c < firstPoint[k + 1]; c++) {
                predicted[c] += shift;
                trialSpeed[c] = speed(c);
                double lacking = LEAST_GAP * margin(k) - predicted[c];
                double least = Math.min(trialSpeed[c] + 2 * lacking / h, cap[c] + 2 * bend);
                problem.contacts.target[c] = Math.max(problem.contacts.target[c] - bend, least);
            }
        }
    }

    private boolean areSpheres(int k) {
        int pair = held.pairs()[k];
        return traits.isSphere[held.first(pair)] && traits.isSphere[held.second(pair)];
    }

    private double speed(int c) {
        return problem.contacts.separationSpeed(c, problem.bodies);
    }

    private double smallerRadius(int k) {
        int pair = held.pairs()[k];
        return Math.min(traits.radius[held.first(pair)], traits.radius[held.second(pair)]);
    }

    /** How fast a pair's speeds of approach change as it turns and slides (m/s^2), roughly. */
    private double bend(int k) {
        int a = held.first(held.pairs()[k]);
        int b = held.second(held.pairs()[k]);
        double[] v = problem.bodies.v;
        int p = 6 * problem.body(a);
        int q = 6 * problem.body(b);
        double slide = 0;
        double turnA = 0;
        double turnB = 0;
        for (int axis = 0; axis < 3; axis++) {
            slide += (v[p + axis] - v[q + axis]) * (v[p + axis] - v[q + axis]);
            turnA += v[p + 3 + axis] * v[p + 3 + axis];
            turnB += v[q + 3 + axis] * v[q + 3 + axis];
        }
        double bend = slide / (traits.radius[a] + traits.radius[b]);
        if (!traits.arePlainBalls(a, b)) {
            bend += turnA > 0 ? turnA * traits.radius[a] : 0;
            bend += turnB > 0 ? turnB * traits.radius[b] : 0;
        }
        return bend;
    }

    /** By how much a pair is farther apart at the trial's end than its contacts foretell (m). */
    private double shift(int k) {
        int a = held.first(held.pairs()[k]);
        int b = held.second(held.pairs()[k]);
        double foretold = Double.POSITIVE_INFINITY;
        for (int c = firstPoint[k]; c < firstPoint[k + 1]; c++) {
            foretold = Math.min(foretold, predicted[c]);
        }
        paths().endPose(a, pose);
        paths().endPose(b, other);
        touch.find(a, pose, b, other, held.reach(held.pairs()[k]), manifold);
        double gap = Double.POSITIVE_INFINITY;
        for (int c = 0; c < manifold.count; c++) {
            gap = Math.min(gap, manifold.gap[c]);
        }
        return manifold.count > 0 && foretold < Double.POSITIVE_INFINITY ? gap - foretold : 0;
    }

    /** The solver's first guess: the forces that the contacts had last. */
    private void guess(double h) {
        for (int k = 0; k < held.pairCount(); k++) {
            int a = held.first(held.pairs()[k]);
            int b = held.second(held.pairs()[k]);
            double within = 0.05 * smallerRadius(k);
            double sign = a < b ? h : -h;
            for (int c = firstPoint[k]; c < firstPoint[k + 1]; c++) {
                findPlace(Math.min(a, b), c);
                int found = memory.nearest(entry[k], place[0], place[1], place[2], within);
                if (found < 0) {
                    problem.contacts.guess(c, 0, 0, 0, 0);
                } else {
                    problem.contacts.guess(
                            c,
                            h * memory.force(found),
                            sign * memory.force(found + 1),
                            sign * memory.force(found + 2),
                            sign * memory.force(found + 3));
                }
            }
        }
    }

    /**
     * Solves for the contact forces over {@code h} (s).
     *
     * @return by how much (m/s, rad/s) the bodies are to end differently from the trial
     */
    private double solve(double h) {
        ContactSolver solver = isPassing || problem.contacts.areCentral() ? rough : forces;
        solver.solve(problem.bodies, problem.contacts);
        for (int k = 0; k < held.pairCount(); k++) {
            remember(k, h);
        }
        double most = 0;
        for (int k = 0; k < 6 * held.memberCount(); k++) {
            most = Math.max(most, Math.abs(problem.bodies.v[k] - endVelocity[k]));
        }
        return most;
    }

    private void remember(int k, double h) {
        int a = held.first(held.pairs()[k]);
        int b = held.second(held.pairs()[k]);
        double sign = a < b ? 1 / h : -1 / h;
        memory.clearPoints(entry[k]);
        for (int c = firstPoint[k]; c < firstPoint[k + 1]; c++) {
            findPlace(Math.min(a, b), c);
            memory.addPoint(
                    entry[k],
                    place[0],
                    place[1],
                    place[2],
                    problem.contacts.jn[c] / h,
                    sign * problem.contacts.jx[c],
                    sign * problem.contacts.jy[c],
                    sign * problem.contacts.jz[c]);
        }
    }

    /** Finds a contact's place (m) in the axes of a body; balls touch at one place alone. */
    private void findPlace(int slot, int c) {
        if (problem.contacts.isCentral[c]) {
            Arrays.fill(place, 0);
            return;
        }
        int body = problem.body(slot);
        double x = problem.contacts.px[c] - problem.bodies.x[3 * body];
        double y = problem.contacts.py[c] - problem.bodies.x[3 * body + 1];
        double z = problem.contacts.pz[c] - problem.bodies.x[3 * body + 2];
        double w = bodies.column(BodyState.QW)[slot];
        double qx = bodies.column(BodyState.QX)[slot];
        double qy = bodies.column(BodyState.QY)[slot];
        double qz = bodies.column(BodyState.QZ)[slot];
        double tx = 2 * (qz * y - qy * z);
        double ty = 2 * (qx * z - qz * x);
        double tz = 2 * (qy * x - qx * y);
        place[0] = x + w * tx + (qz * ty - qy * tz);
        place[1] = y + w * ty + (qx * tz - qz * tx);
        place[2] = z + w * tz + (qy * tx - qx * ty);
    }

    /** Spreads what the solver found over {@code h} (s). */
    private void setForces(double h) {
        for (int k = 0; k < held.memberCount(); k++) {
            int slot = held.members()[k];
            // A ball without friction is not turned, not even by rounding.
            int kept = traits.isBall[slot] && traits.friction[slot] == 0 ? 3 : 6;
            boolean any = false;
            for (int c = 0; c < 6; c++) {
                double force = c < kept ? problem.bodies.impulse[6 * k + c] / h : 0;
                applied[6 * k + c] = force;
                any |= force != 0;
            }
            if (any) {
                trajectories.forces().set(slot, applied, 6 * k);
            } else {
                trajectories.forces().clear(slot);
            }
        }
    }

    /** Whether the contact forces of the trial give the bodies energy. */
    private boolean doesWork(double h, int count) {
        double work = 0;
        double scale = 0;
        for (int k = 0; k < count; k++) {
            int slot = held.members()[k];
            paths().load(slot, curve);
            curve.spinAt(0.5 * (curve.from() + curve.to()), spin, 0);
            for (int axis = 0; axis < 3; axis++) {
                int at = 6 * k + axis;
                double turned =
                        h / 6 * (startVelocity[at + 3] + 4 * spin[axis] + endVelocity[at + 3]);
                work += applied[at] * (toMiddle[at] + toEnd[at]);
                work += applied[at + 3] * turned;
                scale +=
                        bodies.column(BodyState.PX + axis)[slot] * startVelocity[at]
                                + bodies.column(BodyState.LX + axis)[slot] * startVelocity[at + 3];
                scale += h * h * applied[at] * applied[at] * bodies.inverseMass()[slot];
            }
        }
        return work > WORK_TOLERANCE * scale / 2 + mending(h);
    }

    /** The least gap (m) of a pair with the forces that have been solved for. */
    private double endGap(int k, double h) {
        return leastEnd(firstPoint[k], firstPoint[k + 1], h);
    }

    private double leastEnd(int from, int to, double h) {
        double least = Double.POSITIVE_INFINITY;
        for (int c = from; c < to; c++) {
            least = Math.min(least, predicted[c] + h / 2 * (speed(c) - trialSpeed[c]));
        }
        return least;
    }

    /** The work (J) that it takes to open the gaps as far as they have been opened. */
    private double mending(double h) {
        double work = 0;
        for (int k = 0; k < held.pairCount(); k++) {
            boolean isStraight = bend(k) * h * h < SLACK * margin(k);
            double together = endGap(k, h) - startGap[k];
            for (int c = firstPoint[k]; c < firstPoint[k + 1]; c++) {
                double opened = isStraight ? leastEnd(c, c + 1, h) - before[c] : together;
                work +=
                        problem.contacts.jn[c]
                                / h
                                * Math.clamp(opened, SLACK * margin(k), margin(k));
            }
        }
        return work;
    }
}
