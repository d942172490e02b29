package org.auvsim.core.step;

import org.auvsim.core.dynamics.BodyGroups;
import org.auvsim.core.dynamics.EquationsOfMotion;
import org.auvsim.core.dynamics.Integrator;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.volume.Pose;

/**
 * Integrates bodies, a block at a time, and traces their segments: what one lane does, with the
 * scratch that it needs. Instants are offsets (s) from the frame's beginning.
 */
final class SegmentIntegrator {
    /** Segments that should be cut into no more parts than these are fine. */
    static final int FINE = 2;

    private static final int NONE = -1;

    /** Where the spin at a segment's start and end is noted. */
    private static final int START = 0;

    private static final int END = 3;

    private final BodyTraits traits;
    private final EquationsOfMotion equations;
    private final BodyGroups groups;
    private final Integrator integrator;
    private final ContactForces forces;
    private final Paths paths;
    private final double[][] end;

    private final Block block;
    private final BodyGroups.Batch batch;
    private final SegmentTrace trace;

    /** How many bodies of the block are traced; those behind are anchors of groups. */
    private int traced;

    /** For what is cut out of the block, as its segments have to be shorter. */
    private final Block single;

    private final int[] alone = new int[1];
    private final Pose pose = new Pose();

    private double time;
    private double length;

    /** The first body that has been found to end with numbers that are not finite; else -1. */
    int notFinite = NONE;

    /** The last body whose forces are too stiff for the shortest segment; else -1. */
    int tooStiff = NONE;

    /** Whether a segment has been made shorter than it was to be. */
    boolean hasCuts;

    SegmentIntegrator(
            BodyState bodies,
            BodyTraits traits,
            EquationsOfMotion equations,
            Integrator integrator,
            ContactForces forces,
            Paths paths) {
        this.traits = traits;
        this.equations = equations;
        this.groups = equations.groups();
        this.integrator = integrator;
        this.forces = forces;
        this.paths = paths;
        end = paths.ends();
        block = new Block(groups.capacity());
        single = new Block(groups.capacity());
        batch = new BodyGroups.Batch(groups.capacity());
        trace = new SegmentTrace(groups.capacity(), bodies.radius());
    }

    /** A frame begins, at the world's {@code time} (s). */
    void begin(double time, double length) {
        this.time = time;
        this.length = length;
        notFinite = NONE;
        tooStiff = NONE;
        hasCuts = false;
    }

    /** The frame's length (s). */
    double length() {
        return length;
    }

    /** The block into which bodies are loaded. */
    Block block() {
        return block;
    }

    /** How many of the bodies that were asked for have been loaded. */
    int loaded() {
        return traced;
    }

    /** Loads the bodies of the slots {@code first} to {@code last - 1} at the frame's beginning. */
    void loadRow(int first, int last) {
        traced = last - first;
        equations.load(block, first, traced, time);
    }

    /** As {@link #load} at the frame's beginning, where no contact pushes yet. */
    void loadAtBeginning(int[] slots, int first, int last) {
        traced = groups.fill(slots, first, last, batch);
        equations.load(block, batch.slots, batch.count, time);
    }

    /**
     * Loads as many of the bodies {@code first} to {@code last - 1} as fit into the block, with
     * those that have to be integrated beside them, in their present states at an offset.
     */
    void load(int[] slots, int first, int last, double offset) {
        traced = load(block, slots, first, last, offset);
    }

    private int load(Block to, int[] slots, int first, int last, double offset) {
        int number = groups.fill(slots, first, last, batch);
        equations.load(to, batch.slots, batch.count, time + offset);
        forces.push(to);
        return number;
    }

    /** The same for bodies that nothing is coupled to, or whose couplings do not matter. */
    void loadUncoupled(int[] slots, int first, int last, double offset) {
        traced = Math.min(Block.SIZE, last - first);
        System.arraycopy(slots, first, batch.slots, 0, traced);
        equations.load(block, batch.slots, traced, time + offset);
        forces.push(block);
    }

    /** A body with all that it is coupled to; valid until the next call. */
    int[] unit(int slot) {
        if (groups.isCoupled(slot)) {
            return groups.members(slot);
        }
        alone[0] = slot;
        return alone;
    }

    /** Integrates the loaded bodies over a duration (s) and traces nothing. */
    void project(double duration) {
        equations.evaluate(block);
        integrator.advance(equations, block, duration);
    }

    /** Makes the block's present states the ends of its bodies' segments. */
    void writeEnds() {
        writeEnds(block);
    }

    private void writeEnds(Block of) {
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            of.scatter(of.state[c], end[c]);
        }
    }

    /** Writes the velocities of the loaded bodies: six numbers each, from body {@code first} on. */
    void writeVelocities(double[] to, int first) {
        equations.motions(block);
        for (int i = 0; i < traced; i++) {
            int at = 6 * (first + i);
            to[at] = block.vx[i];
            to[at + 1] = block.vy[i];
            to[at + 2] = block.vz[i];
            to[at + 3] = block.wx[i];
            to[at + 4] = block.wy[i];
            to[at + 5] = block.wz[i];
        }
    }

    /**
     * Integrates the loaded bodies from one offset to another and traces their segments; a body
     * whose forces are too stiff for that gets a shorter segment.
     */
    void integrate(double from, double to) {
        advance(block, from, to);
        if (!block.hasSubSteps() && !block.hasFixed) {
            traceAll(from, to);
            return;
        }
        // What is cut takes the trace's place: it has to come last.
        for (int i = 0; i < traced; i++) {
            if (parts(block, i) == 1) {
                trace(block, i, from, to);
            }
        }
        int size;
        for (int i = 0; i < traced; i += size) {
            size = groups.size(block.slot(i));
            if (parts(block, i) > 1) {
                cut(unit(block.slot(i)), parts(block, i), from, to);
            }
        }
    }

    /**
     * The same, but no segment is made shorter.
     *
     * @return into how many parts the segments should be cut
     */
    int integrateWhole(double from, double to) {
        advance(block, from, to);
        int parts = 1;
        for (int i = 0; i < traced; i++) {
            trace(block, i, from, to);
            parts = Math.max(parts, block.subSteps(i));
        }
        return parts;
    }

    private void advance(Block of, double from, double to) {
        equations.evaluate(of);
        trace.begin(of);
        if (!traits.areAllSpheres) {
            equations.spin(of);
            paths.noteSpin(of, START);
        }
        integrator.advance(equations, of, to - from);
        writeEnds(of);
        if (traits.areAllSpheres) {
            equations.velocities(of);
        } else {
            equations.motions(of);
            paths.noteSpin(of, END);
        }
        trace.end(of, to - from);
    }

    /** Into how many parts the segments of a body, and all that it is coupled to, should be cut. */
    private int parts(Block of, int i) {
        int slot = of.slot(i);
        if (!groups.isCoupled(slot)) {
            return of.subSteps(i);
        }
        int most = 1;
        for (int member : groups.members(slot)) {
            most = Math.max(most, of.subSteps(of.indexOf(member)));
        }
        return most;
    }

    /** Traces segments that are as many times shorter than asked as makes them fine. */
    private void cut(int[] unit, int atLeast, double from, double to) {
        hasCuts = true;
        double last = to;
        int parts = atLeast;
        boolean isFine = false;
        while (!isFine) {
            last = from + (to - from) / parts;
            if (isTooShort(from, last)) {
                tooStiff = unit[0];
                return;
            }
            load(single, unit, 0, unit.length, from);
            advance(single, from, last);
            isFine = parts(single, 0) <= FINE;
            parts *= 2;
        }
        for (int i = 0; i < unit.length; i++) {
            trace(single, i, from, last);
        }
    }

    /** Whether nothing is gained any more by segments as short as this. */
    boolean isTooShort(double from, double to) {
        return (to - from) * 2 * Block.MOST_SUB_STEPS < length;
    }

    /** Writes curve and box of body {@code i} of a block. */
    private void trace(Block of, int i, double from, double to) {
        int slot = of.slot(i);
        if (traits.isFixed[slot]) {
            paths.standStill(slot, pose, from, to);
            return;
        }
        paths.trace(trace, of, i, i + 1, from, to);
        noteIfNotFinite(of, i);
    }

    /** Writes curves and boxes of all that is traced of the block, nothing of which is fixed. */
    private void traceAll(double from, double to) {
        paths.trace(trace, block, 0, traced, from, to);
        for (int i = 0; i < traced; i++) {
            noteIfNotFinite(block, i);
        }
    }

    private void noteIfNotFinite(Block of, int i) {
        if (notFinite < 0 && !trace.isFinite(i)) {
            notFinite = of.slot(i);
        }
    }
}
