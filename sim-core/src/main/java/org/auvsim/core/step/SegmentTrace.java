package org.auvsim.core.step;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyState;

/**
 * The cubics of a block's segments from their ends: positions and velocities there, and what the
 * hull of the control points, widened by the bounding radius, extends to. Scratch of one lane; its
 * loops are short and without branches for the compiler to vectorise them.
 */
final class SegmentTrace {
    private static final int AXES = 3;

    private final double[] radii;
    private final double[] radius;
    private final double[][] p0;
    private final double[][] p1;
    private final double[][] p2;
    private final double[][] low;
    private final double[][] high;

    /** Finite if all is that a segment ends with. */
    private final double[] sum;

    /** For blocks of up to {@code capacity} bodies; their bounding radii (m) are by slot. */
    SegmentTrace(int capacity, double[] radii) {
        this.radii = radii;
        radius = new double[capacity];
        p0 = new double[AXES][capacity];
        p1 = new double[AXES][capacity];
        p2 = new double[AXES][capacity];
        low = new double[AXES][capacity];
        high = new double[AXES][capacity];
        sum = new double[capacity];
    }

    /** Notes where the bodies of the block are; their velocities have been found. */
    void begin(Block block) {
        for (int axis = 0; axis < AXES; axis++) {
            System.arraycopy(block.state[BodyState.X + axis], 0, p0[axis], 0, block.count);
            System.arraycopy(block.rate[BodyState.X + axis], 0, p1[axis], 0, block.count);
        }
    }

    /** Finds the cubics from there to where the bodies are a time (s) later. */
    void end(Block block, double duration) {
        int count = block.count;
        block.gather(radii, radius);
        for (int axis = 0; axis < AXES; axis++) {
            double[] p3 = block.state[BodyState.X + axis];
            double[] v3 = block.rate[BodyState.X + axis];
            double third = duration / 3;
            control(count, p0[axis], p1[axis], p2[axis], p3, v3, third);
            extend(count, p0[axis], p1[axis], p2[axis], p3, low[axis], high[axis]);
            widen(count, radius, low[axis], high[axis]);
        }
        addEnds(block, sum);
    }

    /** The inner control points; in p1 is the velocity at the start. */
    private static void control(
            int count,
            double[] p0,
            double[] p1,
            double[] p2,
            double[] p3,
            double[] v3,
            double third) {
        for (int i = 0; i < count; i++) {
            p1[i] = p0[i] + p1[i] * third;
            p2[i] = p3[i] - v3[i] * third;
        }
    }

    private static void extend(
            int count,
            double[] p0,
            double[] p1,
            double[] p2,
            double[] p3,
            double[] low,
            double[] high) {
        for (int i = 0; i < count; i++) {
            low[i] = Math.min(Math.min(p0[i], p1[i]), Math.min(p2[i], p3[i]));
            high[i] = Math.max(Math.max(p0[i], p1[i]), Math.max(p2[i], p3[i]));
        }
    }

    private static void widen(int count, double[] radius, double[] low, double[] high) {
        for (int i = 0; i < count; i++) {
            low[i] -= radius[i];
            high[i] += radius[i];
        }
    }

    private static void addEnds(Block b, double[] sum) {
        add(b.count, sum, b.vx, b.vy, b.vz, b.state[BodyState.X]);
        addOn(b.count, sum, b.wx, b.wy, b.wz, b.state[BodyState.Y]);
        addOn(b.count, sum, b.state[BodyState.QW], b.state[BodyState.Z]);
    }

    private static void add(
            int count, double[] sum, double[] a, double[] b, double[] c, double[] d) {
        for (int i = 0; i < count; i++) {
            sum[i] = a[i] + b[i] + c[i] + d[i];
        }
    }

    private static void addOn(
            int count, double[] sum, double[] a, double[] b, double[] c, double[] d) {
        for (int i = 0; i < count; i++) {
            sum[i] += a[i] + b[i] + c[i] + d[i];
        }
    }

    private static void addOn(int count, double[] sum, double[] a, double[] b) {
        for (int i = 0; i < count; i++) {
            sum[i] += a[i] + b[i];
        }
    }

    /** Whether body {@code i} ends with finite numbers. */
    boolean isFinite(int i) {
        return Math.abs(sum[i]) <= Double.MAX_VALUE;
    }

    /** Writes the control points of the bodies {@code from} to {@code to - 1} of the block. */
    void writeCurves(Block block, int from, int to, double[] curve) {
        for (int axis = 0; axis < AXES; axis++) {
            double[] q0 = p0[axis];
            double[] q1 = p1[axis];
            double[] q2 = p2[axis];
            double[] q3 = block.state[BodyState.X + axis];
            for (int i = from; i < to; i++) {
                int at = Paths.CURVE * block.slot(i) + axis;
                curve[at] = q0[i];
                curve[at + 3] = q1[i];
                curve[at + 6] = q2[i];
                curve[at + 9] = q3[i];
            }
        }
    }

    /** Writes the boxes of the bodies {@code from} to {@code to - 1} of the block. */
    void writeBoxes(Block block, int from, int to, double[] box) {
        for (int axis = 0; axis < AXES; axis++) {
            double[] least = low[axis];
            double[] greatest = high[axis];
            for (int i = from; i < to; i++) {
                int at = Paths.BOX * block.slot(i) + axis;
                box[at] = least[i];
                box[at + AXES] = greatest[i];
            }
        }
    }
}
