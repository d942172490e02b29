package org.auvsim.core.step;

import org.auvsim.core.dynamics.BodyGroups;
import org.auvsim.core.dynamics.EquationsOfMotion;
import org.auvsim.core.dynamics.Integrator;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.volume.Pose;

import java.util.Arrays;
import java.util.function.IntConsumer;

/**
 * How all bodies move through one frame, the time from a step's beginning to its end.
 *
 * <p>A body's trajectory is a segment: from its state at the segment's start, which stands in the
 * world's {@link BodyState}, to that at its end, which is integrated and stands here. In between
 * its position follows the cubic that has the same positions and velocities at both ends, in Bezier
 * form; the hull of the four control points, widened by the body's bounding radius, is its swept
 * box. At first all segments fill the frame; a body that collides begins a new one there.
 *
 * <p>Instants are offsets (s) from the frame's beginning; bodies go by their slots.
 */
final class Trajectories {
    private final BodyState bodies;
    private final BodyGroups groups;
    private final Lanes lanes;
    private final ContactForces forces;
    private final Paths paths;
    private final double[][] end;
    private final int[] version;
    private final SegmentLog log;

    private final FrameBlocks blocks;
    private final SegmentIntegrator[] integrators;
    private final IntConsumer integrateLane = this::integrateLane;

    /** The one that goes on within the frame, when no lanes run. */
    private final SegmentIntegrator one;

    private final JointSegments joint;
    private final int[] alike = new int[Block.SIZE];
    private final BodyCurve cut = new BodyCurve();
    private final Pose place = new Pose();

    private double time;
    private double length;
    private boolean isCommitted;

    Trajectories(
            BodyState bodies,
            BodyTraits traits,
            EquationsOfMotion equations,
            Integrator integrator,
            Lanes lanes) {
        this.bodies = bodies;
        this.lanes = lanes;
        groups = equations.groups();
        forces = new ContactForces(bodies.count());
        paths = new Paths(bodies, traits, forces);
        end = paths.ends();
        version = new int[bodies.count()];
        log = new SegmentLog(bodies);
        blocks = new FrameBlocks(groups, bodies.count());
        integrators = new SegmentIntegrator[lanes.count()];
        for (int lane = 0; lane < integrators.length; lane++) {
            integrators[lane] =
                    new SegmentIntegrator(bodies, traits, equations, integrator, forces, paths);
        }
        one = integrators[0];
        joint = new JointSegments(one, version);
    }

    BodyGroups groups() {
        return groups;
    }

    int count() {
        return version.length;
    }

    /** Where the bodies are on their segments. */
    Paths paths() {
        return paths;
    }

    /** What contacts exert on them. */
    ContactForces forces() {
        return forces;
    }

    /** How many segments each body has had in this frame beside its first. */
    int[] versions() {
        return version;
    }

    /** Integrates all bodies over a frame that begins at the world's {@code time} (s). */
    void begin(double time, double length) {
        this.time = time;
        this.length = length;
        Arrays.fill(version, 0);
        isCommitted = false;
        log.clear();
        forces.clear();
        lanes.run(integrateLane);
    }

    private void integrateLane(int lane) {
        SegmentIntegrator integrator = integrators[lane];
        integrator.begin(time, length);
        int from = (int) ((long) blocks.count() * lane / integrators.length);
        int to = (int) ((long) blocks.count() * (lane + 1) / integrators.length);
        for (int b = from; b < to; b++) {
            blocks.load(b, integrator);
            integrator.integrate(0, length);
        }
    }

    /**
     * Ends a body's segment at an offset, and those of all that it is coupled to: its state there
     * becomes its present one. The position is that of the curve, on which contacts are found, the
     * rest is integrated. {@link #restart} has to follow.
     */
    void moveTo(int slot, double offset) {
        double from = paths.startOf(slot);
        if (from == offset) {
            return;
        }
        int[] unit = one.unit(slot);
        if (offset == paths.endOf(slot)) {
            for (int member : unit) {
                takeEnd(member, offset);
            }
            return;
        }
        one.load(unit, 0, unit.length, from);
        take(from, offset);
    }

    /** Integrates the loaded bodies from where their segments began to where they end now. */
    private void take(double from, double offset) {
        one.project(offset - from);
        for (int i = 0; i < one.loaded(); i++) {
            take(one.block(), i, offset);
        }
    }

    private void take(Block block, int i, double offset) {
        int slot = block.slot(i);
        log.keep(slot);
        paths.load(slot, cut);
        cut.poseAt(offset, place);
        for (int c = BodyState.PX; c < BodyState.COLUMNS; c++) {
            bodies.column(c)[slot] = block.state[c][i];
        }
        bodies.column(BodyState.X)[slot] = place.x;
        bodies.column(BodyState.Y)[slot] = place.y;
        bodies.column(BodyState.Z)[slot] = place.z;
        boolean turnsAlong = paths.turn();
        bodies.column(BodyState.QW)[slot] = turnsAlong ? place.qw : block.state[BodyState.QW][i];
        bodies.column(BodyState.QX)[slot] = turnsAlong ? place.qx : block.state[BodyState.QX][i];
        bodies.column(BodyState.QY)[slot] = turnsAlong ? place.qy : block.state[BodyState.QY][i];
        bodies.column(BodyState.QZ)[slot] = turnsAlong ? place.qz : block.state[BodyState.QZ][i];
        paths.beginAt(slot, offset);
    }

    private void takeEnd(int slot, double offset) {
        log.keep(slot);
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            bodies.column(c)[slot] = end[c][slot];
        }
        paths.beginAt(slot, offset);
    }

    /** The same for several bodies: those whose segments began together go in blocks. */
    void moveTo(int[] slots, int number, double offset) {
        int count = 0;
        double start = 0;
        for (int k = 0; k < number; k++) {
            int slot = slots[k];
            double from = paths.startOf(slot);
            if (groups.isCoupled(slot) || from == offset || offset == paths.endOf(slot)) {
                moveTo(slot, offset);
                continue;
            }
            if (count == Block.SIZE || (count > 0 && from != start)) {
                moveAlike(count, start, offset);
                count = 0;
            }
            start = from;
            alike[count++] = slot;
        }
        moveAlike(count, start, offset);
    }

    private void moveAlike(int number, double from, double offset) {
        if (number > 0) {
            one.loadUncoupled(alike, 0, number, from);
            take(from, offset);
        }
    }

    /**
     * Begins new segments for bodies that have been moved to an offset, up to the frame's end, with
     * the contact forces that they have been given.
     */
    void restart(int[] slots, int number, double offset) {
        for (int first = 0; first < number; first += one.loaded()) {
            one.load(slots, first, number, offset);
            one.integrate(offset, length);
        }
        for (int k = 0; k < number; k++) {
            version[slots[k]]++;
        }
    }

    /**
     * The same for bodies that hang together: their segments end together, at {@code latest} or, if
     * the forces on one of them are stiff, before.
     *
     * @param endVelocities receives the velocities at the segments' ends: six numbers a body, of
     *     the origin (m/s), then angular (rad/s), world
     * @return the offset where the segments end
     */
    double restartTogether(
            int[] slots, int number, double offset, double latest, double[] endVelocities) {
        return joint.restart(slots, number, offset, latest, endVelocities);
    }

    /**
     * Writes the velocities that bodies have in their present states, as {@link #restartTogether}.
     */
    void velocitiesNow(int[] slots, int number, double[] to) {
        joint.velocitiesNow(slots, number, to);
    }

    /** Makes the ends of all segments the present state. */
    void commit() {
        bodies.exchange(end);
        isCommitted = true;
    }

    /** Ends the frame early: makes the states at an offset the present one. */
    void commitAt(double offset) {
        for (int b = 0; b < blocks.count(); b++) {
            blocks.load(b, one);
            if (offset > 0) {
                one.project(offset);
            }
            one.writeEnds();
        }
        for (int slot = 0; slot < version.length; slot++) {
            if (version[slot] > 0 || paths.startOf(slot) > 0) {
                moveTo(slot, offset);
                for (int c = 0; c < BodyState.COLUMNS; c++) {
                    end[c][slot] = bodies.column(c)[slot];
                }
            }
        }
        commit();
    }

    /** Gives all bodies the state back that they had when the frame began. */
    void undo() {
        if (isCommitted) {
            bodies.exchange(end);
            isCommitted = false;
        }
        log.restore();
    }

    /** Whether a segment of the frame's beginning is shorter than the frame. */
    boolean hasCuts() {
        boolean any = false;
        for (SegmentIntegrator integrator : integrators) {
            any |= integrator.hasCuts;
        }
        return any;
    }

    /**
     * Requires that all segments traced so far can be followed.
     *
     * @param motion whose bodies they are of
     * @throws StepException if the forces on a body are too stiff for the shortest segment, or its
     *     motion is not finite
     */
    void requireSound(Motion motion) {
        int tooStiff = -1;
        int notFinite = -1;
        for (SegmentIntegrator integrator : integrators) {
            tooStiff = firstOf(tooStiff, integrator.tooStiff);
            notFinite = firstOf(notFinite, integrator.notFinite);
        }
        motion.requireMild(tooStiff, length);
        motion.requireFinite(notFinite, length);
    }

    /** The lower of two slots, each of which is -1 if there is none. */
    private static int firstOf(int one, int another) {
        return one < 0 || (another >= 0 && another < one) ? another : one;
    }
}
