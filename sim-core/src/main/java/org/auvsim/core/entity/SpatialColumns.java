package org.auvsim.core.entity;

import org.jspecify.annotations.Nullable;

/**
 * The numbers of the bodies that have a {@link SpatialInertia}, one array each, by slot: what {@link
 * SpatialBlock} computes with. Zeros for all other bodies.
 */
final class SpatialColumns {
    /** The inverse of the whole inertia: 21 numbers, row by row from the diagonal on. */
    static final int INVERSE = 0;

    /** Added mass, linear by linear: xx, xy, xz, yy, yz, zz. */
    static final int ADDED = 21;

    /** Added mass, linear by angular: three rows. */
    static final int ADDED_CROSS = 27;

    /** Centre of mass (m, body). */
    static final int CENTRE = 36;

    static final int COLUMNS = 39;

    /** Where each element of a symmetric 3x3 matrix stands, row by row. */
    static final int[] SYMMETRIC = {0, 1, 2, 1, 3, 4, 2, 4, 5};

    /** Without length until the first such body comes: most worlds have none. */
    private final double[][] columns;

    private int capacity;

    SpatialColumns(int capacity) {
        this(new double[COLUMNS][0], capacity);
    }

    private SpatialColumns(double[][] columns, int capacity) {
        this.columns = columns;
        this.capacity = capacity;
    }

    SpatialColumns copy() {
        return new SpatialColumns(BodyState.clones(columns), capacity);
    }

    void grow(int toCapacity) {
        capacity = toCapacity;
        if (!isEmpty()) {
            BodyState.growAll(columns, toCapacity);
        }
    }

    private boolean isEmpty() {
        return columns[0].length == 0;
    }

    void set(int slot, @Nullable SpatialInertia inertia) {
        if (isEmpty()) {
            if (inertia == null) {
                return;
            }
            BodyState.growAll(columns, capacity);
        }
        for (double[] column : columns) {
            column[slot] = 0;
        }
        if (inertia == null) {
            return;
        }
        int next = INVERSE;
        for (int row = 0; row < 6; row++) {
            for (int c = row; c < 6; c++) {
                columns[next++][slot] = inertia.inverse[6 * row + c];
            }
        }
        for (int row = 0; row < 3; row++) {
            for (int c = 0; c < 3; c++) {
                columns[ADDED + SYMMETRIC[3 * row + c]][slot] = inertia.added[6 * row + c];
                columns[ADDED_CROSS + 3 * row + c][slot] = inertia.added[6 * row + 3 + c];
            }
        }
        columns[CENTRE][slot] = inertia.centreOfMass().x();
        columns[CENTRE + 1][slot] = inertia.centreOfMass().y();
        columns[CENTRE + 2][slot] = inertia.centreOfMass().z();
    }

    void remove(int slot, int count) {
        for (double[] column : columns) {
            if (!isEmpty()) {
                System.arraycopy(column, slot + 1, column, slot, count - slot - 1);
            }
        }
    }

    /** Copies the numbers of the block's bodies. */
    void gather(Block b, double[][] to) {
        for (int c = 0; c < COLUMNS; c++) {
            b.gather(columns[c], to[c]);
        }
    }
}
