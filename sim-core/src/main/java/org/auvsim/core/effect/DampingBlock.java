package org.auvsim.core.effect;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.MotionAxis;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The damping of all bodies of a world; a body without has zeros, a block without is passed over.
 */
final class DampingBlock implements BlockEffect {
    /** One element of both matrices, by slot. */
    private static final class Element {
        final int row;
        final int column;
        final double[] linear;
        final double[] quadratic;
        private boolean hasLinear;
        private boolean hasQuadratic;

        Element(int row, int column, int slots) {
            this.row = row;
            this.column = column;
            linear = new double[slots];
            quadratic = new double[slots];
        }

        void add(int slot, double a, double b) {
            linear[slot] += a;
            quadratic[slot] += b;
            hasLinear |= a != 0;
            hasQuadratic |= b != 0;
        }
    }

    /** The six of the diagonal in order, then those beside it that some body has. */
    private final List<Element> elements = new ArrayList<>();

    private final boolean[] damped;

    DampingBlock(List<List<Effect>> bySlot) {
        int slots = bySlot.size();
        for (int axis = 0; axis < ThroughWater.AXES; axis++) {
            elements.add(new Element(axis, axis, slots));
        }
        damped = new boolean[slots];
        for (int slot = 0; slot < slots; slot++) {
            for (Effect effect : bySlot.get(slot)) {
                add(slot, (Damping) effect);
                damped[slot] = true;
            }
        }
    }

    private void add(int slot, Damping damping) {
        addDiagonal(0, slot, damping.linear(), damping.quadratic());
        addDiagonal(3, slot, damping.angularLinear(), damping.angularQuadratic());
        for (DampingTerm term : damping.term()) {
            element(term.row(), term.column()).add(slot, term.linear(), term.quadratic());
        }
    }

    private void addDiagonal(int axis, int slot, Vec3 linear, Vec3 quadratic) {
        elements.get(axis).add(slot, linear.x(), quadratic.x());
        elements.get(axis + 1).add(slot, linear.y(), quadratic.y());
        elements.get(axis + 2).add(slot, linear.z(), quadratic.z());
    }

    private Element element(MotionAxis row, MotionAxis column) {
        for (Element element : elements) {
            if (element.row == row.index() && element.column == column.index()) {
                return element;
            }
        }
        elements.add(new Element(row.index(), column.index(), damped.length));
        return elements.getLast();
    }

    @Override
    public void add(Block b) {
        if (!ThroughWater.isAnyOf(b, damped)) {
            return;
        }
        for (int e = 0; e < elements.size(); e++) {
            damp(b, elements.get(e), e < ThroughWater.AXES);
        }
        ThroughWater.push(b);
    }

    private static void damp(Block b, Element element, boolean first) {
        double[] force = b.scratch[element.row];
        if (first) {
            Arrays.fill(force, 0, b.count, 0);
        }
        double[] v = ThroughWater.velocity(b, element.column);
        double[] a = b.scratch[ThroughWater.FREE];
        double[] k = b.scratch[ThroughWater.FREE + 1];
        if (element.hasLinear) {
            b.gather(element.linear, a);
        }
        if (element.hasQuadratic) {
            b.gather(element.quadratic, k);
        }
        if (element.hasLinear && element.hasQuadratic) {
            subtract(b.count, force, v, a, k);
        } else if (element.hasLinear) {
            subtractLinear(b.count, force, v, a);
        } else if (element.hasQuadratic) {
            subtractQuadratic(b.count, force, v, k);
        }
    }

    private static void subtract(int count, double[] force, double[] v, double[] a, double[] k) {
        for (int i = 0; i < count; i++) {
            force[i] -= (a[i] + k[i] * Math.abs(v[i])) * v[i];
        }
    }

    private static void subtractLinear(int count, double[] force, double[] v, double[] a) {
        for (int i = 0; i < count; i++) {
            force[i] -= a[i] * v[i];
        }
    }

    private static void subtractQuadratic(int count, double[] force, double[] v, double[] k) {
        for (int i = 0; i < count; i++) {
            force[i] -= k[i] * Math.abs(v[i]) * v[i];
        }
    }
}
