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
    /** Parts of a stiff motion that are asked to be cut in no more than these are fine. */
    private static final int FINE = 2;

    private final BodyState bodies;
    private final BodyTraits traits;
    private final EquationsOfMotion equations;
    private final Integrator integrator;
    private final Lanes lanes;
    private final int count;
    private final ContactForces forces;
    private final Paths paths;
    private final double[][] end;
    private final int[] version;
    private final Worker[] workers;
    private final IntConsumer integrateLane = this::integrateLane;
    private final SegmentLog log;
    private final int[] one = new int[1];
    private final int[] some = new int[Block.SIZE];
    private final BodyGroups groups;

    /**
     * Where coupled bodies are: all slots with groups side by side, and where each block begins.
     */
    private final int[] inOrder;

    private final int[] blockStart;
    private final BodyCurve cut = new BodyCurve();
    private final Pose place = new Pose();
    private boolean isCommitted;
    private double time;
    private double length;

    /** What one lane needs for itself. */
    private static final class Worker {
        final Block block;
        final Block single;
        final BodyGroups.Batch batch;
        final int[] one = new int[1];
        final Pose pose = new Pose();
        final SegmentTrace trace;

        /** How many bodies of the block are traced; those behind are anchors of groups. */
        int traced;

        int notFinite = -1;
        int tooStiff = -1;
        boolean hasCuts;

        Worker(int capacity, double[] radii) {
            block = new Block(capacity);
            single = new Block(capacity);
            batch = new BodyGroups.Batch(capacity);
            trace = new SegmentTrace(capacity, radii);
        }
    }

    Trajectories(
            BodyState bodies,
            BodyTraits traits,
            EquationsOfMotion equations,
            Integrator integrator,
            Lanes lanes) {
        this.bodies = bodies;
        this.traits = traits;
        this.equations = equations;
        this.integrator = integrator;
        this.lanes = lanes;
        this.groups = equations.groups();
        count = bodies.count();
        forces = new ContactForces(count);
        paths = new Paths(bodies, traits, forces);
        end = paths.ends();
        version = new int[count];
        log = new SegmentLog(bodies);
        workers = new Worker[lanes.count()];
        for (int lane = 0; lane < workers.length; lane++) {
            workers[lane] = new Worker(groups.capacity(), bodies.radius());
        }
        inOrder = groups.inOrder();
        blockStart = blockStarts();
    }

    /** Where the blocks of a frame begin, if bodies are coupled; the last entry is the end. */
    private int[] blockStarts() {
        int[] starts = new int[inOrder.length + 1];
        int blocks = 0;
        while (starts[blocks] < inOrder.length) {
            int from = starts[blocks++];
            starts[blocks] = from + groups.fill(inOrder, from, inOrder.length, workers[0].batch);
        }
        return Arrays.copyOf(starts, blocks + 1);
    }

    BodyGroups groups() {
        return groups;
    }

    int count() {
        return count;
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
        Worker worker = workers[lane];
        worker.notFinite = -1;
        worker.tooStiff = -1;
        worker.hasCuts = false;
        boolean isPlain = groups.isEmpty();
        int blocks = isPlain ? (count + Block.SIZE - 1) / Block.SIZE : blockStart.length - 1;
        int from = (int) ((long) blocks * lane / workers.length);
        int to = (int) ((long) blocks * (lane + 1) / workers.length);
        for (int b = from; b < to; b++) {
            int first = isPlain ? b * Block.SIZE : blockStart[b];
            loadFrame(worker, first);
            integrate(worker, 0, length);
        }
    }

    /** Loads bodies at the frame's beginning, from a place in the order of blocks on. */
    private void loadFrame(Worker worker, int first) {
        if (groups.isEmpty()) {
            worker.traced = Math.min(Block.SIZE, count - first);
            equations.load(worker.block, first, worker.traced, time);
        } else {
            worker.traced = groups.fill(inOrder, first, count, worker.batch);
            equations.load(worker.block, worker.batch.slots, worker.batch.count, time);
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
        int[] unit = unit(slot, one);
        if (offset == paths.endOf(slot)) {
            for (int member : unit) {
                takeEnd(member, offset);
            }
            return;
        }
        Block block = workers[0].block;
        load(workers[0], unit, 0, unit.length, from);
        integrator.advance(equations, block, offset - from);
        for (int i = 0; i < unit.length; i++) {
            take(block, i, offset);
        }
    }

    /** A body with all that it is coupled to. */
    private int[] unit(int slot, int[] alone) {
        if (groups.isCoupled(slot)) {
            return groups.members(slot);
        }
        alone[0] = slot;
        return alone;
    }

    /** Body {@code i} of the block has been integrated to an offset, where its segment ends now. */
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
        int alike = 0;
        double start = 0;
        for (int k = 0; k < number; k++) {
            int slot = slots[k];
            double from = paths.startOf(slot);
            if (groups.isCoupled(slot) || from == offset || offset == paths.endOf(slot)) {
                moveTo(slot, offset);
                continue;
            }
            if (alike == Block.SIZE || (alike > 0 && from != start)) {
                moveAlike(alike, start, offset);
                alike = 0;
            }
            start = from;
            some[alike++] = slot;
        }
        moveAlike(alike, start, offset);
    }

    private void moveAlike(int number, double from, double offset) {
        if (number == 0) {
            return;
        }
        Block block = workers[0].block;
        equations.load(block, some, number, time + from);
        forces.push(block);
        integrator.advance(equations, block, offset - from);
        for (int i = 0; i < number; i++) {
            take(block, i, offset);
        }
    }

    /**
     * Begins new segments for bodies that have been moved to an offset, up to the frame's end, with
     * the contact forces that they have been given.
     */
    void restart(int[] slots, int number, double offset) {
        for (int first = 0; first < number; first += workers[0].traced) {
            load(workers[0], slots, first, number, offset);
            integrate(workers[0], offset, length);
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
        Worker worker = workers[0];
        int notFinite = worker.notFinite;
        double last = latest;
        int fine = latest < length ? FINE : 1;
        int wanted = project(slots, number, offset, last, endVelocities);
        for (int parts = wanted; wanted > fine; parts *= 2) {
            fine = FINE;
            last = offset + (latest - offset) / parts;
            if (isTooShort(offset, last)) {
                worker.tooStiff = slots[0];
                return latest;
            }
            worker.notFinite = notFinite;
            wanted = project(slots, number, offset, last, endVelocities);
        }
        return last;
    }

    /** Traces bodies from one offset to another; into how many parts that should be cut. */
    private int project(int[] slots, int number, double from, double to, double[] endVelocities) {
        Worker worker = workers[0];
        Block block = worker.block;
        int parts = 1;
        for (int first = 0; first < number; first += worker.traced) {
            load(worker, slots, first, number, from);
            advance(worker, block, from, to);
            for (int i = 0; i < worker.traced; i++) {
                trace(worker, block, i, from, to);
                parts = Math.max(parts, block.subSteps(i));
            }
            tellVelocities(endVelocities, first);
        }
        for (int k = 0; k < number; k++) {
            version[slots[k]]++;
        }
        return parts;
    }

    /** Whether nothing is gained any more by parts as short as this. */
    private boolean isTooShort(double from, double to) {
        return (to - from) * 2 * Block.MOST_SUB_STEPS < length;
    }

    /** Tells the velocities that bodies have in their present states, as {@link #restart} does. */
    void velocitiesNow(int[] slots, int number, double[] to) {
        // No force matters here, and so nobody they couple.
        Worker worker = workers[0];
        for (int first = 0; first < number; first += worker.traced) {
            worker.traced = Math.min(Block.SIZE, number - first);
            System.arraycopy(slots, first, some, 0, worker.traced);
            equations.load(worker.block, some, worker.traced, time);
            forces.push(worker.block);
            tellVelocities(to, first);
        }
    }

    /**
     * Loads as many of the bodies from {@code first} on, up to {@code end}, as fit into a block.
     */
    private void load(Worker worker, int[] slots, int first, int end, double offset) {
        worker.traced = groups.fill(slots, first, end, worker.batch);
        equations.load(worker.block, worker.batch.slots, worker.batch.count, time + offset);
        forces.push(worker.block);
    }

    private void tellVelocities(double[] to, int first) {
        Block block = workers[0].block;
        equations.motions(block);
        for (int i = 0; i < workers[0].traced; i++) {
            int at = 6 * (first + i);
            to[at] = block.vx[i];
            to[at + 1] = block.vy[i];
            to[at + 2] = block.vz[i];
            to[at + 3] = block.wx[i];
            to[at + 4] = block.wy[i];
            to[at + 5] = block.wz[i];
        }
    }

    /** Makes the ends of all segments the present state. */
    void commit() {
        bodies.exchange(end);
        isCommitted = true;
    }

    /** Ends the frame early: makes the states at an offset the present one. */
    void commitAt(double offset) {
        Block block = workers[0].block;
        for (int first = 0; first < count; first += workers[0].traced) {
            loadFrame(workers[0], first);
            if (offset > 0) {
                integrator.advance(equations, block, offset);
            }
            for (int c = 0; c < BodyState.COLUMNS; c++) {
                block.scatter(block.state[c], end[c]);
            }
        }
        for (int slot = 0; slot < count; slot++) {
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

    /**
     * Integrates the loaded bodies from one offset to another and traces their segments; a body
     * whose forces are too stiff for that gets a shorter segment.
     */
    private void integrate(Worker worker, double from, double to) {
        Block block = worker.block;
        advance(worker, block, from, to);
        if (!block.hasSubSteps() && !block.hasFixed) {
            traceAll(worker, block, from, to);
            return;
        }
        int traced = worker.traced;
        for (int i = 0; i < traced; i++) {
            if (parts(block, i) == 1) {
                trace(worker, block, i, from, to);
            }
        }
        int size;
        for (int i = 0; i < traced; i += size) {
            size = groups.size(block.slot(i));
            if (parts(block, i) > 1) {
                cut(worker, unit(block.slot(i), worker.one), parts(block, i), from, to);
            }
        }
    }

    /** Into how many parts the steps of a body, and all that it is coupled to, should be cut. */
    private int parts(Block block, int i) {
        int slot = block.slot(i);
        if (!groups.isCoupled(slot)) {
            return block.subSteps(i);
        }
        int most = 1;
        for (int member : groups.members(slot)) {
            most = Math.max(most, block.subSteps(block.indexOf(member)));
        }
        return most;
    }

    private void advance(Worker worker, Block block, double from, double to) {
        measure(block, 0);
        worker.trace.begin(block);
        integrator.advance(equations, block, to - from);
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            block.scatter(block.state[c], end[c]);
        }
        measure(block, 3);
        worker.trace.end(block, to - from);
    }

    /** Traces segments that are as many times shorter than asked as makes them fine. */
    private void cut(Worker worker, int[] unit, int atLeast, double from, double to) {
        worker.hasCuts = true;
        Block block = worker.single;
        double last = to;
        int parts = atLeast;
        boolean isFine = false;
        while (!isFine) {
            last = from + (to - from) / parts;
            if (isTooShort(from, last)) {
                worker.tooStiff = unit[0];
                return;
            }
            groups.fill(unit, 0, unit.length, worker.batch);
            equations.load(block, worker.batch.slots, worker.batch.count, time + from);
            forces.push(block);
            advance(worker, block, from, last);
            isFine = parts(block, 0) <= FINE;
            parts *= 2;
        }
        for (int i = 0; i < unit.length; i++) {
            trace(worker, block, i, from, last);
        }
    }

    /** Fills the velocities of the block, and notes the angular ones at start (0) or end (3). */
    private void measure(Block block, int at) {
        if (traits.areAllSpheres) {
            equations.velocities(block);
            return;
        }
        equations.motions(block);
        paths.noteSpin(block, at);
    }

    /** Writes curve and box of body {@code i} of the block. */
    private void trace(Worker worker, Block block, int i, double from, double to) {
        int slot = block.slot(i);
        if (traits.isFixed[slot]) {
            paths.standStill(slot, worker.pose, from, to);
            return;
        }
        paths.trace(worker.trace, block, i, i + 1, from, to);
        requireFinite(worker, block, i);
    }

    /** Writes curves and boxes of all that is traced of the block, nothing of which is fixed. */
    private void traceAll(Worker worker, Block block, double from, double to) {
        paths.trace(worker.trace, block, 0, worker.traced, from, to);
        for (int i = 0; i < worker.traced; i++) {
            requireFinite(worker, block, i);
        }
    }

    /** Notes the first body that does not end with finite numbers. */
    private static void requireFinite(Worker worker, Block block, int i) {
        if (worker.notFinite < 0 && !worker.trace.isFinite(i)) {
            worker.notFinite = block.slot(i);
        }
    }

    /** Whether forces may be so stiff that a segment ends before its frame. */
    boolean mayEndEarly() {
        return equations.mayBeStiff();
    }

    /** Whether a segment of the frame's beginning is shorter than the frame. */
    boolean hasCuts() {
        boolean any = false;
        for (Worker worker : workers) {
            any |= worker.hasCuts;
        }
        return any;
    }

    /**
     * The slot of a body whose forces are too stiff for the shortest segment; -1 if there is none.
     */
    int anyTooStiff() {
        int first = -1;
        for (Worker worker : workers) {
            if (worker.tooStiff >= 0 && (first < 0 || worker.tooStiff < first)) {
                first = worker.tooStiff;
            }
        }
        return first;
    }

    /** The slot of a body whose end is not a finite number, the first one; -1 if there is none. */
    int anyNotFinite() {
        int first = -1;
        for (Worker worker : workers) {
            if (worker.notFinite >= 0 && (first < 0 || worker.notFinite < first)) {
                first = worker.notFinite;
            }
        }
        return first;
    }
}
