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
    /** Numbers of a curve: 12 of four control points (m), then the offsets of start and end. */
    static final int CURVE = 16;

    static final int START = 12;
    static final int END = 13;

    private static final int SPIN = 6;

    /** Parts of a stiff motion that are asked to be cut in no more than these are fine. */
    private static final int FINE = 2;

    /** Numbers of a box: min x, y, z, max x, y, z (m). */
    static final int BOX = 6;

    private final BodyState bodies;
    private final BodyTraits traits;
    private final EquationsOfMotion equations;
    private final Integrator integrator;
    private final Lanes lanes;
    private final int count;
    private final double[][] end;
    private final double[] curve;
    private final double[] box;
    private final int[] version;

    /** Angular velocities (rad/s, world) at start and end, where orientations matter at all. */
    private final double[] spin;

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
    private final double[] contactForce;
    private final boolean[] isPushed;
    private boolean anyPushed;
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
        final double[] vx;
        final double[] vy;
        final double[] vz;

        /** How many bodies of the block are traced; those behind are anchors of groups. */
        int traced;

        int notFinite = -1;
        int tooStiff = -1;
        boolean hasCuts;

        Worker(int capacity) {
            block = new Block(capacity);
            single = new Block(capacity);
            batch = new BodyGroups.Batch(capacity);
            vx = new double[capacity];
            vy = new double[capacity];
            vz = new double[capacity];
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
        end = new double[BodyState.COLUMNS][bodies.column(0).length];
        curve = new double[CURVE * count];
        box = new double[BOX * count];
        version = new int[count];
        spin = new double[traits.areAllSpheres ? 0 : SPIN * count];
        log = new SegmentLog(bodies);
        contactForce = new double[6 * count];
        isPushed = new boolean[count];
        workers = new Worker[lanes.count()];
        for (int lane = 0; lane < workers.length; lane++) {
            workers[lane] = new Worker(groups.capacity());
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

    double[] curves() {
        return curve;
    }

    double[] boxes() {
        return box;
    }

    /** How many segments each body has had in this frame beside its first. */
    int[] versions() {
        return version;
    }

    /** One column of the bodies' states at the ends of their segments. */
    double[] end(int column) {
        return end[column];
    }

    double startOf(int body) {
        return curve[CURVE * body + START];
    }

    double endOf(int body) {
        return curve[CURVE * body + END];
    }

    /** Integrates all bodies over a frame that begins at the world's {@code time} (s). */
    void begin(double time, double length) {
        this.time = time;
        this.length = length;
        Arrays.fill(version, 0);
        isCommitted = false;
        log.clear();
        if (anyPushed) {
            Arrays.fill(isPushed, false);
            anyPushed = false;
        }
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
        double from = startOf(slot);
        if (from == offset) {
            return;
        }
        int[] unit = unit(slot, one);
        if (offset == endOf(slot)) {
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
        load(slot, cut);
        cut.poseAt(offset, place);
        for (int c = BodyState.PX; c < BodyState.COLUMNS; c++) {
            bodies.column(c)[slot] = block.state[c][i];
        }
        bodies.column(BodyState.X)[slot] = place.x;
        bodies.column(BodyState.Y)[slot] = place.y;
        bodies.column(BodyState.Z)[slot] = place.z;
        boolean turnsAlong = spin.length > 0;
        bodies.column(BodyState.QW)[slot] = turnsAlong ? place.qw : block.state[BodyState.QW][i];
        bodies.column(BodyState.QX)[slot] = turnsAlong ? place.qx : block.state[BodyState.QX][i];
        bodies.column(BodyState.QY)[slot] = turnsAlong ? place.qy : block.state[BodyState.QY][i];
        bodies.column(BodyState.QZ)[slot] = turnsAlong ? place.qz : block.state[BodyState.QZ][i];
        curve[CURVE * slot + START] = offset;
    }

    private void takeEnd(int slot, double offset) {
        log.keep(slot);
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            bodies.column(c)[slot] = end[c][slot];
        }
        curve[CURVE * slot + START] = offset;
    }

    /**
     * The same for several bodies, most of which are on their first segment: those go in blocks.
     */
    void moveTo(int[] slots, int number, double offset) {
        int fresh = 0;
        for (int k = 0; k < number; k++) {
            if (startOf(slots[k]) != 0 || groups.isCoupled(slots[k])) {
                moveTo(slots[k], offset);
            } else if (offset > 0) {
                some[fresh++] = slots[k];
            }
            if (fresh == Block.SIZE || k == number - 1) {
                moveFresh(fresh, offset);
                fresh = 0;
            }
        }
    }

    private void moveFresh(int number, double offset) {
        if (number == 0) {
            return;
        }
        Block block = workers[0].block;
        equations.load(block, some, number, time);
        push(block);
        integrator.advance(equations, block, offset);
        for (int i = 0; i < number; i++) {
            take(block, i, offset);
        }
    }

    /** A coordinate of the curve at a share of its segment (de Casteljau). */
    private double at(int slot, int axis, double s) {
        int p = CURVE * slot + axis;
        double a = curve[p] + s * (curve[p + 3] - curve[p]);
        double b = curve[p + 3] + s * (curve[p + 6] - curve[p + 3]);
        double c = curve[p + 6] + s * (curve[p + 9] - curve[p + 6]);
        double d = a + s * (b - a);
        return d + s * (b + s * (c - b) - d);
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
            push(worker.block);
            tellVelocities(to, first);
        }
    }

    /**
     * Loads as many of the bodies from {@code first} on, up to {@code end}, as fit into a block.
     */
    private void load(Worker worker, int[] slots, int first, int end, double offset) {
        worker.traced = groups.fill(slots, first, end, worker.batch);
        equations.load(worker.block, worker.batch.slots, worker.batch.count, time + offset);
        push(worker.block);
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

    /** Sets the constant force (N) and torque (N m, world) of contacts on a body. */
    void setContactForce(int slot, double[] forceAndTorque, int from) {
        for (int c = 0; c < 6; c++) {
            contactForce[6 * slot + c] = forceAndTorque[from + c];
        }
        isPushed[slot] = true;
        anyPushed = true;
    }

    void clearContactForce(int slot) {
        isPushed[slot] = false;
    }

    private void push(Block block) {
        if (!anyPushed) {
            return;
        }
        block.hasContactForces = true;
        for (int i = 0; i < block.count; i++) {
            int at = 6 * block.slot(i);
            double share = isPushed[block.slot(i)] ? 1 : 0;
            block.contactFx[i] = share * contactForce[at];
            block.contactFy[i] = share * contactForce[at + 1];
            block.contactFz[i] = share * contactForce[at + 2];
            block.contactTx[i] = share * contactForce[at + 3];
            block.contactTy[i] = share * contactForce[at + 4];
            block.contactTz[i] = share * contactForce[at + 5];
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
            if (version[slot] > 0 || startOf(slot) > 0) {
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
        if (!block.hasSubSteps()) {
            for (int i = 0; i < worker.traced; i++) {
                trace(worker, block, i, from, to);
            }
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
        System.arraycopy(block.vx, 0, worker.vx, 0, block.count);
        System.arraycopy(block.vy, 0, worker.vy, 0, block.count);
        System.arraycopy(block.vz, 0, worker.vz, 0, block.count);
        integrator.advance(equations, block, to - from);
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            block.scatter(block.state[c], end[c]);
        }
        measure(block, 3);
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
            push(block);
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
        for (int i = 0; i < block.count; i++) {
            int to = SPIN * block.slot(i) + at;
            spin[to] = block.wx[i];
            spin[to + 1] = block.wy[i];
            spin[to + 2] = block.wz[i];
        }
    }

    /** Loads the curve of a body's segment. */
    void load(int slot, BodyCurve to) {
        int at = CURVE * slot;
        to.path(curve[at + START], curve[at + END], curve, at);
        double[] qw = bodies.column(BodyState.QW);
        double[] qx = bodies.column(BodyState.QX);
        double[] qy = bodies.column(BodyState.QY);
        double[] qz = bodies.column(BodyState.QZ);
        if (traits.isFixed[slot] || spin.length == 0) {
            to.unturned(qw[slot], qx[slot], qy[slot], qz[slot]);
            return;
        }
        int w = SPIN * slot;
        to.turnFrom(qw[slot], qx[slot], qy[slot], qz[slot], spin[w], spin[w + 1], spin[w + 2]);
        to.turnTo(
                end[BodyState.QW][slot],
                end[BodyState.QX][slot],
                end[BodyState.QY][slot],
                end[BodyState.QZ][slot],
                spin[w + 3],
                spin[w + 4],
                spin[w + 5]);
    }

    /** Writes curve and box of body {@code i} of the block. */
    private void trace(Worker worker, Block block, int i, double from, double to) {
        int slot = block.slot(i);
        if (traits.isFixed[slot]) {
            standStill(worker, slot, from, to);
            return;
        }
        double third = (to - from) / 3;
        double radius = bodies.radius()[slot];
        double[] x = bodies.column(BodyState.X);
        double[] y = bodies.column(BodyState.Y);
        double[] z = bodies.column(BodyState.Z);
        trace(
                slot,
                0,
                x[slot],
                worker.vx[i],
                block.state[BodyState.X][i],
                block.vx[i],
                third,
                radius);
        trace(
                slot,
                1,
                y[slot],
                worker.vy[i],
                block.state[BodyState.Y][i],
                block.vy[i],
                third,
                radius);
        trace(
                slot,
                2,
                z[slot],
                worker.vz[i],
                block.state[BodyState.Z][i],
                block.vz[i],
                third,
                radius);
        curve[CURVE * slot + START] = from;
        curve[CURVE * slot + END] = to;
        double sum =
                block.vx[i]
                        + block.vy[i]
                        + block.vz[i]
                        + block.wx[i]
                        + block.wy[i]
                        + block.wz[i]
                        + block.state[BodyState.QW][i]
                        + block.state[BodyState.X][i]
                        + block.state[BodyState.Y][i]
                        + block.state[BodyState.Z][i];
        if (!(Math.abs(sum) <= Double.MAX_VALUE) && worker.notFinite < 0) {
            worker.notFinite = slot;
        }
    }

    private void trace(
            int slot,
            int axis,
            double p0,
            double v0,
            double p3,
            double v3,
            double third,
            double r) {
        double p1 = p0 + v0 * third;
        double p2 = p3 - v3 * third;
        int at = CURVE * slot + axis;
        curve[at] = p0;
        curve[at + 3] = p1;
        curve[at + 6] = p2;
        curve[at + 9] = p3;
        double low = p0 < p1 ? p0 : p1;
        double high = p0 < p1 ? p1 : p0;
        double low2 = p2 < p3 ? p2 : p3;
        double high2 = p2 < p3 ? p3 : p2;
        box[BOX * slot + axis] = (low < low2 ? low : low2) - r;
        box[BOX * slot + axis + 3] = (high > high2 ? high : high2) + r;
    }

    /**
     * How strongly two bodies are pressed together (m/s^2) at an offset by what is no contact
     * force: their relative acceleration against a direction that leads from b to a. Turning is
     * left out.
     */
    double pressure(int a, int b, double offset, double nx, double ny, double nz) {
        return nx * (acceleration(b, 0, offset) - acceleration(a, 0, offset))
                + ny * (acceleration(b, 1, offset) - acceleration(a, 1, offset))
                + nz * (acceleration(b, 2, offset) - acceleration(a, 2, offset));
    }

    /** The same along the line between their origins at the offset. */
    double pressure(int a, int b, double offset) {
        double nx = at(a, 0, share(a, offset)) - at(b, 0, share(b, offset));
        double ny = at(a, 1, share(a, offset)) - at(b, 1, share(b, offset));
        double nz = at(a, 2, share(a, offset)) - at(b, 2, share(b, offset));
        double distance = Math.sqrt(nx * nx + ny * ny + nz * nz);
        return distance == 0 ? 0 : pressure(a, b, offset, nx, ny, nz) / distance;
    }

    private double share(int slot, double offset) {
        double start = curve[CURVE * slot + START];
        return (offset - start) / (curve[CURVE * slot + END] - start);
    }

    private double acceleration(int slot, int axis, double offset) {
        int p = CURVE * slot + axis;
        double start = curve[CURVE * slot + START];
        double h = curve[CURVE * slot + END] - start;
        double s = (offset - start) / h;
        double first = curve[p] - 2 * curve[p + 3] + curve[p + 6];
        double last = curve[p + 3] - 2 * curve[p + 6] + curve[p + 9];
        double pushed = isPushed[slot] ? contactForce[6 * slot + axis] : 0;
        return 6 * (first + s * (last - first)) / (h * h) - pushed * bodies.inverseMass()[slot];
    }

    /**
     * How fast two bodies approach along the line between their origins at the frame's beginning:
     * there (m/s), and with their velocities at the ends of their segments.
     */
    void approaches(int a, int b, double[] to) {
        int p = CURVE * a;
        int q = CURVE * b;
        double squared = 0;
        double start = 0;
        double finish = 0;
        for (int axis = 0; axis < 3; axis++, p++, q++) {
            double d = curve[p] - curve[q];
            squared += d * d;
            start -= d * (curve[p + 3] - curve[p] - curve[q + 3] + curve[q]);
            finish -= d * (curve[p + 9] - curve[p + 6] - curve[q + 9] + curve[q + 6]);
        }
        double k = 3 / (length * Math.sqrt(squared));
        to[0] = k * start;
        to[1] = k * finish;
    }

    /** No less than how far (m) two bodies move relative to each other over their segments. */
    double relativeWay(int a, int b) {
        double way = 0;
        for (int k = 0; k < 9; k += 3) {
            double squared = 0;
            for (int axis = k; axis < k + 3; axis++) {
                int p = CURVE * a + axis;
                int q = CURVE * b + axis;
                double d = curve[p + 3] - curve[p] - curve[q + 3] + curve[q];
                squared += d * d;
            }
            way += Math.sqrt(squared);
        }
        return way;
    }

    private void standStill(Worker worker, int slot, double from, double to) {
        Pose pose = worker.pose;
        pose(slot, pose);
        for (int at = CURVE * slot; at < CURVE * slot + 12; at += 3) {
            curve[at] = pose.x;
            curve[at + 1] = pose.y;
            curve[at + 2] = pose.z;
        }
        curve[CURVE * slot + START] = from;
        curve[CURVE * slot + END] = to;
        traits.volume[slot].bounds(pose, box, BOX * slot);
    }

    /** Where a body is in its present state. */
    void pose(int slot, Pose to) {
        to.x = bodies.column(BodyState.X)[slot];
        to.y = bodies.column(BodyState.Y)[slot];
        to.z = bodies.column(BodyState.Z)[slot];
        to.qw = bodies.column(BodyState.QW)[slot];
        to.qx = bodies.column(BodyState.QX)[slot];
        to.qy = bodies.column(BodyState.QY)[slot];
        to.qz = bodies.column(BodyState.QZ)[slot];
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
