package org.auvsim.core.entity;

import org.auvsim.core.math.Vec3;

import java.util.List;

/**
 * The resultants of the constant forces on each body, so that a step costs the same for one named
 * force as for fifty.
 *
 * <p>A force fixed in the body's axes gives a constant force and torque in those axes. A force F
 * fixed in the world's axes that acts at body point r gives the torque (R r) x F, which is linear
 * in the rotation matrix R: the sum over all such forces needs only the matrix A = sum of r F^T,
 * since the torque's components are the antisymmetric part of R A.
 */
public final class AppliedForces {
    private static final int WORLD_FORCE = 0;
    private static final int BODY_FORCE = 3;
    private static final int BODY_TORQUE = 6;
    private static final int MOMENT = 9;
    static final int COLUMNS = 18;

    private final double[][] columns;
    private int slotsWithMoment;

    AppliedForces(int capacity) {
        this(new double[COLUMNS][capacity], 0);
    }

    private AppliedForces(double[][] columns, int slotsWithMoment) {
        this.columns = columns;
        this.slotsWithMoment = slotsWithMoment;
    }

    AppliedForces copy() {
        return new AppliedForces(BodyState.clones(columns), slotsWithMoment);
    }

    void grow(int capacity) {
        BodyState.growAll(columns, capacity);
    }

    void clear(int slot) {
        if (hasMoment(slot)) {
            slotsWithMoment--;
        }
        for (double[] column : columns) {
            column[slot] = 0;
        }
    }

    void remove(int slot, int count) {
        clear(slot);
        for (double[] column : columns) {
            System.arraycopy(column, slot + 1, column, slot, count - slot - 1);
            column[count - 1] = 0;
        }
    }

    private boolean hasMoment(int slot) {
        for (int c = MOMENT; c < COLUMNS; c++) {
            if (columns[c][slot] != 0) {
                return true;
            }
        }
        return false;
    }

    /** Replaces the resultants of a body by those of these forces and propulsors, in this order. */
    void set(int slot, Iterable<NamedForce> forces, List<Propulsor> propulsors) {
        clear(slot);
        for (NamedForce force : forces) {
            if (force.frame() == Frame.BODY) {
                addBodyForce(slot, force.vector(), force.point());
            } else {
                add(WORLD_FORCE, slot, force.vector());
                if (!force.point().equals(Vec3.ZERO)) {
                    addMoment(slot, force.point(), force.vector());
                }
            }
        }
        for (Propulsor propulsor : propulsors) {
            addBodyForce(slot, propulsor.thrust(), propulsor.position());
        }
        if (hasMoment(slot)) {
            slotsWithMoment++;
        }
    }

    private void addBodyForce(int slot, Vec3 force, Vec3 point) {
        add(BODY_FORCE, slot, force);
        add(BODY_TORQUE, slot, point.cross(force));
    }

    private void addMoment(int slot, Vec3 r, Vec3 f) {
        add(MOMENT, slot, f.times(r.x()));
        add(MOMENT + 3, slot, f.times(r.y()));
        add(MOMENT + 6, slot, f.times(r.z()));
    }

    private void add(int column, int slot, Vec3 v) {
        columns[column][slot] += v.x();
        columns[column + 1][slot] += v.y();
        columns[column + 2][slot] += v.z();
    }

    /** Copies the resultants of the block's bodies into it. */
    public void load(Block b) {
        for (int c = 0; c < (slotsWithMoment > 0 ? COLUMNS : MOMENT); c++) {
            System.arraycopy(columns[c], b.first, b.applied[c], 0, b.count);
        }
    }

    /** Sets force and torque of every body of the block to the resultants loaded there. */
    public void write(Block b) {
        double[][] a = b.applied;
        for (int axis = 0; axis < 3; axis++) {
            System.arraycopy(a[WORLD_FORCE + axis], 0, b.rate[BodyState.PX + axis], 0, b.count);
        }
        b.addToWorld(b.fx, b.fy, b.fz, a[BODY_FORCE], a[BODY_FORCE + 1], a[BODY_FORCE + 2]);
        b.toWorld(b.tx, b.ty, b.tz, a[BODY_TORQUE], a[BODY_TORQUE + 1], a[BODY_TORQUE + 2]);
        if (slotsWithMoment > 0) {
            // (R A)_yz - (R A)_zy and so on.
            addMoment(b, b.tx, b.ryx, b.ryy, b.ryz, 2, 1);
            addMoment(b, b.tx, b.rzx, b.rzy, b.rzz, 1, -1);
            addMoment(b, b.ty, b.rzx, b.rzy, b.rzz, 0, 1);
            addMoment(b, b.ty, b.rxx, b.rxy, b.rxz, 2, -1);
            addMoment(b, b.tz, b.rxx, b.rxy, b.rxz, 1, 1);
            addMoment(b, b.tz, b.ryx, b.ryy, b.ryz, 0, -1);
        }
    }

    /** Column j of A is stored at MOMENT + j, + 3, + 6. */
    private static void addMoment(
            Block b, double[] to, double[] rx, double[] ry, double[] rz, int j, double sign) {
        double[] x = b.applied[MOMENT + j];
        double[] y = b.applied[MOMENT + 3 + j];
        double[] z = b.applied[MOMENT + 6 + j];
        for (int i = 0; i < b.count; i++) {
            to[i] += sign * (rx[i] * x[i] + ry[i] * y[i] + rz[i] * z[i]);
        }
    }
}
