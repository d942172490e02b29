package org.auvsim.core.entity;

import org.jspecify.annotations.Nullable;

/**
 * The numbers of the bodies that have a {@link SpatialInertia}, one array each, by slot: what
 * {@link SpatialBlock} computes with. Zeros for all other bodies.
 */
final class SpatialColumns {
    /** The inverse of the whole inertia: 21 numbers, row by row from the diagonal on. */
    static final int INVERSE = 0;

    /** Centre of mass (m, body). */
    static final int CENTRE = 21;

    static final int COLUMNS = 24;

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
