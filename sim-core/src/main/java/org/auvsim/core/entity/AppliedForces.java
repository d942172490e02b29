package org.auvsim.core.entity;

import org.auvsim.core.math.Vec3;

import java.util.Arrays;
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
    private final double[] sum = new double[COLUMNS];

    /** How many bodies have something in the group of columns that begins at an index. */
    private final int[] users = new int[COLUMNS];

    AppliedForces(int capacity) {
        this(new double[COLUMNS][capacity]);
    }

    private AppliedForces(double[][] columns) {
        this.columns = columns;
    }

    AppliedForces copy() {
        AppliedForces copy = new AppliedForces(BodyState.clones(columns));
        System.arraycopy(users, 0, copy.users, 0, COLUMNS);
        return copy;
    }

    void grow(int capacity) {
        BodyState.growAll(columns, capacity);
    }

    void clear(int slot) {
        set(slot, List.of(), List.of());
    }

    void remove(int slot, int count) {
        clear(slot);
        for (double[] column : columns) {
            System.arraycopy(column, slot + 1, column, slot, count - slot - 1);
            column[count - 1] = 0;
        }
    }

    /** Replaces the resultants of a body by those of these forces and actuators, in this order. */
    void set(int slot, Iterable<NamedForce> forces, List<Actuator> actuators) {
        Arrays.fill(sum, 0);
        for (NamedForce force : forces) {
            if (force.frame() == Frame.BODY) {
                addBodyForce(force.vector(), force.point());
            } else {
                add(WORLD_FORCE, 1, force.vector());
                addMoment(force.point(), force.vector());
            }
        }
        for (Actuator actuator : actuators) {
            actuator.constantPush().ifPresent(this::addBodyPush);
        }
        store(slot);
    }

    private void addMoment(Vec3 r, Vec3 f) {
        if (r.x() != 0 || r.y() != 0 || r.z() != 0) {
            add(MOMENT, r.x(), f);
            add(MOMENT + 3, r.y(), f);
            add(MOMENT + 6, r.z(), f);
        }
    }

    private void addBodyForce(Vec3 force, Vec3 point) {
        addBodyPush(new Wrench(force, point.cross(force)));
    }

    private void addBodyPush(Wrench push) {
        add(BODY_FORCE, 1, push.force());
        add(BODY_TORQUE, 1, push.torque());
    }

    private void add(int column, double factor, Vec3 v) {
        sum[column] += factor * v.x();
        sum[column + 1] += factor * v.y();
        sum[column + 2] += factor * v.z();
    }

    private void store(int slot) {
        store(slot, WORLD_FORCE, BODY_FORCE);
        store(slot, BODY_FORCE, BODY_TORQUE);
        store(slot, BODY_TORQUE, MOMENT);
        store(slot, MOMENT, COLUMNS);
    }

    private void store(int slot, int begin, int end) {
        boolean had = false;
        boolean has = false;
        for (int c = begin; c < end; c++) {
            had |= columns[c][slot] != 0;
            has |= sum[c] != 0;
            columns[c][slot] = sum[c];
        }
        users[begin] += (has ? 1 : 0) - (had ? 1 : 0);
    }

    /** Copies the resultants of the block's bodies into it; what no body has is left out. */
    public void load(Block b) {
        load(b, WORLD_FORCE, BODY_FORCE);
        load(b, BODY_FORCE, BODY_TORQUE);
        load(b, BODY_TORQUE, MOMENT);
        load(b, MOMENT, COLUMNS);
    }

    private void load(Block b, int begin, int end) {
        for (int c = begin; users[begin] > 0 && c < end; c++) {
            b.gather(columns[c], b.applied[c]);
        }
    }

    /** Whether something here turns a body of the block; what it has loaded. */
    public boolean turns(Block b) {
        return users[BODY_TORQUE] + users[MOMENT] > 0 && turns(b, BODY_TORQUE);
    }

    private boolean turns(Block b, int begin) {
        for (int c = begin; c < COLUMNS; c++) {
            boolean loaded = users[c < MOMENT ? BODY_TORQUE : MOMENT] > 0;
            for (int i = 0; loaded && i < b.count; i++) {
                if (b.applied[c][i] != 0) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Whether a body has a force that is fixed in its axes. */
    public boolean haveBodyForces() {
        return users[BODY_FORCE] > 0;
    }

    /** Sets force and torque of every body of the block to the resultants loaded there. */
    public void write(Block b) {
        double[][] a = b.applied;
        writeWorldForce(b);
        if (users[BODY_FORCE] > 0) {
            b.addToWorld(b.fx, b.fy, b.fz, a[BODY_FORCE], a[BODY_FORCE + 1], a[BODY_FORCE + 2]);
        }
        if (b.turns()) {
            writeTorque(b);
        }
    }

    private void writeTorque(Block b) {
        double[][] a = b.applied;
        if (users[BODY_TORQUE] > 0) {
            b.toWorld(b.tx, b.ty, b.tz, a[BODY_TORQUE], a[BODY_TORQUE + 1], a[BODY_TORQUE + 2]);
        } else {
            clear(b, BodyState.LX);
        }
        if (users[MOMENT] > 0) {
            // (R A)_yz - (R A)_zy and so on.
            addMoment(b, b.tx, b.ryx, b.ryy, b.ryz, 2, 1);
            addMoment(b, b.tx, b.rzx, b.rzy, b.rzz, 1, -1);
            addMoment(b, b.ty, b.rzx, b.rzy, b.rzz, 0, 1);
            addMoment(b, b.ty, b.rxx, b.rxy, b.rxz, 2, -1);
            addMoment(b, b.tz, b.rxx, b.rxy, b.rxz, 1, 1);
            addMoment(b, b.tz, b.ryx, b.ryy, b.ryz, 0, -1);
        }
    }

    private void writeWorldForce(Block b) {
        if (users[WORLD_FORCE] == 0) {
            clear(b, BodyState.PX);
            return;
        }
        for (int axis = 0; axis < 3; axis++) {
            double[] force = b.applied[WORLD_FORCE + axis];
            System.arraycopy(force, 0, b.rate[BodyState.PX + axis], 0, b.count);
        }
    }

    private static void clear(Block b, int column) {
        double[] x = b.rate[column];
        double[] y = b.rate[column + 1];
        double[] z = b.rate[column + 2];
        for (int i = 0; i < b.count; i++) {
            x[i] = 0;
            y[i] = 0;
            z[i] = 0;
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
