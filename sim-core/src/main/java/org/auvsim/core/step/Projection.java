package org.auvsim.core.step;

import org.auvsim.core.dynamics.BodyGroups;
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
    private final IntFunction<String> names;
    private final BodyGroups groups;
    private final BodyGroups.Batch batch;
    private final int[] parts;
    private final int[] stiff;
    private final int[] together;
    private final boolean[] fine;
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
     * Of these bodies; the block is used only while something is integrated.
     *
     * @param names of the bodies, by slot, for sentences
     */
    Projection(
            BodyState bodies,
            EquationsOfMotion equations,
            Integrator integrator,
            Block block,
            IntFunction<String> names) {
        this.bodies = bodies;
        this.equations = equations;
        this.integrator = integrator;
        this.block = block;
        this.names = names;
        this.groups = equations.groups();
        this.batch = new BodyGroups.Batch(groups.capacity());
        this.parts = new int[bodies.count()];
        this.stiff = new int[block.capacity];
        this.together = new int[block.capacity];
        this.fine = new boolean[block.capacity];
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
                } else {
                    integrate(first);
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
        while (slot < end && known[slot] != round && !groups.isCoupled(slot)) {
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
        if (known[slot] == round) {
            return;
        }
        if (groups.isCoupled(slot)) {
            integrateGroup(groups.members(slot));
        } else {
            integrate(slot, 1);
        }
    }

    /**
     * Integrates the body in a slot, unless it is known, and some behind it: for one who asks in
     * turn and may turn to another instant soon.
     */
    void integrateAhead(int slot) {
        if (known[slot] != round) {
            int free = Math.min(ahead, unknownFrom(slot));
            if (free > 0) {
                integrate(slot, free);
            } else {
                integrate(slot);
            }
            ahead = Math.min(4 * ahead, Block.SIZE);
        }
    }

    void pose(int slot, Pose to) {
        integrate(slot);
        BodyState.pose(columns, slot, to);
    }

    /** Notes that the body in a slot is wanted; {@link #integrateWanted} integrates it. */
    void want(int slot) {
        if (groups.isCoupled(slot)) {
            integrate(slot);
        } else if (known[slot] != round) {
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

    private void integrateGroup(int[] members) {
        loadGroup(members, block);
        integrateBlock();
    }

    private void loadGroup(int[] members, Block to) {
        groups.fill(members, 0, members.length, batch);
        equations.load(to, batch.slots, batch.count, now);
    }

    private void integrateBlock() {
        if (offset != 0) {
            equations.evaluate(block);
            integrator.advance(equations, block, offset);
        }
        for (int c = 0; c < BodyState.COLUMNS; c++) {
            block.scatter(block.state[c], columns[c]);
        }
        for (int i = 0; i < block.count; i++) {
            known[block.slot(i)] = round;
            parts[block.slot(i)] = block.subSteps(i);
        }
        if (block.hasSubSteps()) {
            cut(stiffUnits());
        }
    }

    /** Notes the bodies of the block whose step should be cut, of coupled ones the first. */
    private int stiffUnits() {
        int count = 0;
        int size;
        for (int i = 0; i < block.count; i += size) {
            size = groups.size(block.slot(i));
            int most = 1;
            for (int k = i; k < i + size; k++) {
                most = Math.max(most, block.subSteps(k));
            }
            if (most > 1) {
                stiff[count++] = block.slot(i);
                for (int k = i; k < i + size; k++) {
                    parts[block.slot(k)] = most;
                }
            }
        }
        return count;
    }

    /** Integrates bodies with stiff forces again, in parts: in twice as many until all are fine. */
    private void cut(int count) {
        for (int n = 2; n <= Block.MOST_SUB_STEPS; n *= 2) {
            int alone = 0;
            for (int s = 0; s < count; s++) {
                if (parts[stiff[s]] == n && groups.isCoupled(stiff[s])) {
                    integrateParts(groups.members(stiff[s]), n);
                } else if (parts[stiff[s]] == n) {
                    together[alone++] = stiff[s];
                }
            }
            integrateParts(alone, n);
        }
        for (int s = 0; s < count; s++) {
            if (parts[stiff[s]] > Block.MOST_SUB_STEPS) {
                throw StepException.tooStiff(names.apply(stiff[s]), now, offset);
            }
        }
    }

    /** Of coupled bodies, all are fine or none. */
    private void integrateParts(int[] members, int n) {
        loadGroup(members, block);
        SubSteps.integrate(integrator, equations, block, offset, n, fine);
        boolean areFine = true;
        for (int i = 0; i < block.count; i++) {
            areFine &= fine[i];
        }
        for (int i = 0; i < members.length; i++) {
            keep(members[i], i, areFine, n);
        }
    }

    /** Bodies that are not coupled, so many of those noted. */
    private void integrateParts(int count, int n) {
        if (count > 0) {
            equations.load(block, together, count, now);
            SubSteps.integrate(integrator, equations, block, offset, n, fine);
            for (int i = 0; i < count; i++) {
                keep(together[i], i, fine[i], n);
            }
        }
    }

    private void keep(int slot, int i, boolean isFine, int n) {
        parts[slot] = isFine ? n : 2 * n;
        for (int c = 0; isFine && c < BodyState.COLUMNS; c++) {
            columns[c][slot] = block.state[c][i];
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
