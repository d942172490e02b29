package org.auvsim.core.step;

import org.auvsim.core.dynamics.EquationsOfMotion;
import org.auvsim.core.dynamics.Integrator;
import org.auvsim.core.dynamics.SubSteps;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.volume.Pose;

import java.util.function.IntFunction;

/**
 * The bodies as they will be at one instant, if nothing collides before: integrated from the
 * present snapshot on demand, body by body or with their neighbours.
 */
final class Projection {
    /** So many bodies are integrated ahead at first, and four times as many each time after. */
    private static final int FIRST_AHEAD = 8;

    private final BodyState bodies;
    private final EquationsOfMotion equations;
    private final Integrator integrator;
    private final Block block;
    private final Block single;
    private final IntFunction<String> names;
    private final int[] one = new int[1];
    private final int[] parts;
    private final double[][] columns;
    private final int[] known;
    private final int[] wanted = new int[Block.SIZE];
    private int wantedCount;
    private int round;
    private int ahead;
    private boolean complete;
    private double now;
    private double offset = Double.NaN;

    /**
     * Of these bodies; both blocks are used only while something is integrated.
     *
     * @param names of the bodies, by slot, for sentences
     */
    Projection(
            BodyState bodies,
            EquationsOfMotion equations,
            Integrator integrator,
            Block block,
            Block single,
            IntFunction<String> names) {
        this.bodies = bodies;
        this.equations = equations;
        this.integrator = integrator;
        this.block = block;
        this.single = single;
        this.names = names;
        this.parts = new int[bodies.count()];
        this.columns = new double[BodyState.COLUMNS][bodies.count()];
        this.known = new int[bodies.count()];
    }

    /** The instant (s from the snapshot) that it shows; NaN if none. */
    double offset() {
        return offset;
    }

    /** Turns to another instant; what was known is forgotten. */
    void turnTo(double time, double offset) {
        this.now = time;
        this.offset = offset;
        round++;
        ahead = FIRST_AHEAD;
        complete = false;
    }

    /** Forgets everything, as the snapshot has changed. */
    void forget() {
        turnTo(now, Double.NaN);
    }

    /** Integrates every body, blockwise. */
    void integrateAll() {
        if (!complete) {
            int first = 0;
            while (first < known.length) {
                int count = unknownFrom(first);
                if (count > 0) {
                    integrate(first, count);
                }
                first += Math.max(1, count);
            }
            complete = true;
        }
    }

    /** How many bodies from a slot on are unknown, up to a full block. */
    private int unknownFrom(int first) {
        int slot = first;
        int end = Math.min(first + Block.SIZE, known.length);
        while (slot < end && known[slot] != round) {
            slot++;
        }
        return slot - first;
    }

    /** One column of the state; valid for bodies that have been integrated. */
    double[] column(int column) {
        return columns[column];
    }

    /** Integrates the body in a slot, unless it is known. */
    void integrate(int slot) {
        if (known[slot] != round) {
            integrate(slot, 1);
        }
    }

    /**
     * Integrates the body in a slot, unless it is known, and some behind it: for one who asks in
     * turn and may turn to another instant soon.
     */
    void integrateAhead(int slot) {
        if (known[slot] != round) {
            integrate(slot, Math.min(ahead, known.length - slot));
            ahead = Math.min(4 * ahead, Block.SIZE);
        }
    }

    void pose(int slot, Pose to) {
        integrate(slot);
        to.x = columns[BodyState.X][slot];
        to.y = columns[BodyState.Y][slot];
        to.z = columns[BodyState.Z][slot];
        to.qw = columns[BodyState.QW][slot];
        to.qx = columns[BodyState.QX][slot];
        to.qy = columns[BodyState.QY][slot];
        to.qz = columns[BodyState.QZ][slot];
    }

    /** Notes that the body in a slot is wanted; {@link #integrateWanted} integrates it. */
    void want(int slot) {
        if (known[slot] != round) {
            known[slot] = round;
            wanted[wantedCount++] = slot;
            if (wantedCount == Block.SIZE) {
                integrateWanted();
            }
        }
    }

    /** Integrates the wanted bodies together, which is cheaper than one after the other. */
    void integrateWanted() {
        if (wantedCount > 0) {
            equations.load(block, wanted, wantedCount, now);
            wantedCount = 0;
            integrateBlock();
        }
    }

    private void integrate(int first, int count) {
        equations.load(block, first, count, now);
        integrateBlock();
    }

    private void integrateBlock() {
        if (offset != 0) {
            integrator.advance(equations, block, offset);
        }
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            block.scatter(block.state[c], columns[c]);
        }
        for (int i = 0; i < block.count; i++) {
            known[block.slot(i)] = round;
            parts[block.slot(i)] = block.subSteps(i);
        }
        for (int i = 0; block.hasSubSteps() && i < block.count; i++) {
            if (block.subSteps(i) > 1) {
                cut(block.slot(i), block.subSteps(i));
            }
        }
    }

    /** Integrates a body with stiff forces again, in parts. */
    private void cut(int slot, int atLeast) {
        one[0] = slot;
        parts[slot] =
                SubSteps.integrate(
                        integrator,
                        equations,
                        single,
                        b -> equations.load(b, one, 1, now),
                        offset,
                        atLeast);
        if (parts[slot] == 0) {
            throw StepException.tooStiff(names.apply(slot), now, offset);
        }
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            columns[c][slot] = single.state[c][0];
        }
    }

    /** How many parts were integrated in place of whole steps; of all bodies. */
    long subSteps() {
        integrateAll();
        long sum = 0;
        for (int of : parts) {
            sum += of > 1 ? of : 0;
        }
        return sum;
    }

    /** The slot of a body that has a number which is not finite, -1 if none has. */
    int anyNotFinite() {
        integrateAll();
        for (double[] column : columns) {
            double sum = 0;
            for (int slot = 0; slot < known.length; slot++) {
                sum += 0 * column[slot];
            }
            // 0 times infinity is NaN, and NaN stays.
            if (Double.isNaN(sum)) {
                return firstNotFinite(column);
            }
        }
        return -1;
    }

    private int firstNotFinite(double[] column) {
        int slot = 0;
        while (Double.isFinite(column[slot])) {
            slot++;
        }
        return slot;
    }

    /** Makes this the present state of all bodies. */
    void commit() {
        integrateAll();
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            System.arraycopy(columns[c], 0, bodies.column(c), 0, known.length);
        }
    }
}
