package org.auvsim.core.step;

import static org.auvsim.core.contact.ContactBodies.SPEEDS;

import org.auvsim.core.entity.BodyState;
import org.auvsim.core.volume.Pose;

/**
 * How the bodies of an island move over a segment with the contact forces that are tried. The
 * bodies of a {@link ContactProblem} are placed and given velocities from it.
 */
final class IslandTrial {
    private final BodyState bodies;
    private final BodyTraits traits;
    private final Trajectories trajectories;
    private final ContactProblem problem;
    private final HeldPairs held;

    /** Velocities where the segment starts and where the trial ends: six numbers a body. */
    private double[] startVelocity = new double[SPEEDS];

    private double[] endVelocity = new double[SPEEDS];

    /** How far each body moves from start to middle and from there to the trial's end (m, rad). */
    private double[] wayToMiddle = new double[SPEEDS];

    private double[] wayToEnd = new double[SPEEDS];

    /** The contact forces (N) and torques (N m) of the trial: six numbers a body. */
    private double[] force = new double[SPEEDS];

    private final BodyCurve curve = new BodyCurve();
    private final Pose start = new Pose();
    private final Pose middle = new Pose();
    private final Pose end = new Pose();
    private final double[] spin = new double[3];

    IslandTrial(
            BodyState bodies,
            BodyTraits traits,
            Trajectories trajectories,
            ContactProblem problem,
            HeldPairs held) {
        this.bodies = bodies;
        this.traits = traits;
        this.trajectories = trajectories;
        this.problem = problem;
        this.held = held;
    }

    /** Moves the bodies to an offset and places them there, with the velocities they have. */
    void begin(double offset) {
        int count = held.memberCount();
        reserve(SPEEDS * count);
        trajectories.moveTo(held.members(), count, offset);
        problem.clear();
        for (int k = 0; k < count; k++) {
            int slot = held.members()[k];
            paths().pose(slot, start);
            problem.place(slot, start);
        }
        trajectories.velocitiesNow(held.members(), count, startVelocity);
        useStartVelocity();
    }

    private void reserve(int size) {
        if (startVelocity.length < size) {
            startVelocity = new double[2 * size];
            endVelocity = new double[2 * size];
            wayToMiddle = new double[2 * size];
            wayToEnd = new double[2 * size];
            force = new double[2 * size];
        }
    }

    private Paths paths() {
        return trajectories.paths();
    }

    private int speeds() {
        return SPEEDS * held.memberCount();
    }

    /** Lets the impulses that have been solved for act at the start. */
    void applyImpulses() {
        problem.applyImpulses();
        System.arraycopy(problem.bodies.v, 0, startVelocity, 0, speeds());
    }

    /** Spreads the impulses that have been solved for over {@code h} (s), as constant forces. */
    void setForces(double h) {
        for (int k = 0; k < held.memberCount(); k++) {
            int slot = held.members()[k];
            // A ball without friction is not turned, not even by rounding.
            int kept = traits.isPlainBall(slot) ? 3 : SPEEDS;
            boolean any = false;
            for (int c = 0; c < SPEEDS; c++) {
                int at = SPEEDS * k + c;
                force[at] = c < kept ? problem.bodies.impulse[at] / h : 0;
                any |= force[at] != 0;
            }
            if (any) {
                trajectories.forces().set(slot, force, SPEEDS * k);
            } else {
                trajectories.forces().clear(slot);
            }
        }
    }

    /**
     * Traces the bodies with the forces from one offset to another.
     *
     * @return where the trial ends: earlier if the other forces on a body are stiff
     */
    double trace(double from, double to) {
        return trajectories.restartTogether(
                held.members(), held.memberCount(), from, to, endVelocity);
    }

    /** Places the bodies where the trial has them halfway, and notes how they get there and on. */
    void placeHalfway() {
        problem.clear();
        for (int k = 0; k < held.memberCount(); k++) {
            int slot = held.members()[k];
            paths().pose(slot, start);
            paths().middle(slot, curve, middle);
            paths().endPose(slot, end);
            problem.place(slot, middle);
            boolean turns = !traits.isPlainBall(slot);
            noteWay(start, middle, turns, wayToMiddle, SPEEDS * k);
            noteWay(middle, end, turns, wayToEnd, SPEEDS * k);
        }
    }

    private static void noteWay(Pose from, Pose to, boolean turns, double[] way, int at) {
        way[at] = to.x - from.x;
        way[at + 1] = to.y - from.y;
        way[at + 2] = to.z - from.z;
        way[at + 3] = 0;
        way[at + 4] = 0;
        way[at + 5] = 0;
        if (turns) {
            noteTurn(from, to, way, at + 3);
        }
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

    /** Lets the problem's bodies go their ways from start to middle, as in a unit of time. */
    void useWayToMiddle() {
        problem.setVelocities(held.memberCount(), wayToMiddle);
    }

    /** Lets the problem's bodies go their ways from middle to end, as in a unit of time. */
    void useWayToEnd() {
        problem.setVelocities(held.memberCount(), wayToEnd);
    }

    /** Gives the problem's bodies the velocities that they have at the start. */
    void useStartVelocity() {
        problem.setVelocities(held.memberCount(), startVelocity);
    }

    /** Gives the problem's bodies the velocities with which the trial ends. */
    void useEndVelocity() {
        problem.setVelocities(held.memberCount(), endVelocity);
    }

    /** The same as if the forces had not acted for the {@code h} (s) of the trial. */
    void useUnforcedVelocity(double h) {
        for (int k = 0; k < held.memberCount(); k++) {
            problem.setFree(k, endVelocity, force, h);
        }
    }

    /** The fastest that a body is or turns as the trial ends (m/s, rad/s). */
    double fastest() {
        double fastest = 0;
        for (int i = 0; i < speeds(); i++) {
            fastest = Math.max(fastest, Math.abs(endVelocity[i]));
        }
        return fastest;
    }

    /** By how much (m/s, rad/s) the problem's bodies have been solved to end differently. */
    double difference() {
        double most = 0;
        for (int i = 0; i < speeds(); i++) {
            most = Math.max(most, Math.abs(problem.bodies.v[i] - endVelocity[i]));
        }
        return most;
    }

    /** The work (J) of the contact forces in the {@code h} (s) of the trial (Simpson's rule). */
    double work(double h) {
        double work = 0;
        for (int k = 0; k < held.memberCount(); k++) {
            paths().load(held.members()[k], curve);
            curve.spinAt(0.5 * (curve.from() + curve.to()), spin, 0);
            for (int axis = 0; axis < 3; axis++) {
                int at = SPEEDS * k + axis;
                int turn = at + 3;
                double turned = h / 6 * (startVelocity[turn] + 4 * spin[axis] + endVelocity[turn]);
                work += force[at] * (wayToMiddle[at] + wayToEnd[at]);
                work += force[turn] * turned;
            }
        }
        return work;
    }

    /**
     * The kinetic energy (J) that the bodies have at the start, and that which the contact forces
     * alone would give to bodies at rest within {@code h} (s).
     */
    double energy(double h) {
        double twice = 0;
        for (int k = 0; k < held.memberCount(); k++) {
            int slot = held.members()[k];
            for (int axis = 0; axis < 3; axis++) {
                int at = SPEEDS * k + axis;
                twice +=
                        bodies.column(BodyState.PX + axis)[slot] * startVelocity[at]
                                + bodies.column(BodyState.LX + axis)[slot] * startVelocity[at + 3];
                twice += h * h * force[at] * force[at] * bodies.inverseMass()[slot];
            }
        }
        return twice / 2;
    }
}
