package org.auvsim.core.step;

import java.util.Arrays;

/** The bodies whose boxes overlap the box of one, as the grid tells them. */
final class Neighbours implements ColumnGrid.Pairs {
    private final ColumnGrid grid;
    private int[] lower = new int[16];
    private int[] higher = new int[16];
    private int count;

    Neighbours(ColumnGrid grid) {
        this.grid = grid;
    }

    /** Finds those of a body. */
    void find(int body) {
        count = 0;
        grid.pairsOf(body, this);
    }

    @Override
    public void meet(int a, int b) {
        if (count == lower.length) {
            lower = Arrays.copyOf(lower, 2 * count);
            higher = Arrays.copyOf(higher, 2 * count);
        }
        lower[count] = a;
        higher[count] = b;
        count++;
    }

    int count() {
        return count;
    }

    /** The body itself and neighbour {@code k}: the one of the lower slot. */
    int lower(int k) {
        return lower[k];
    }

    /** The same: the one of the higher slot. */
    int higher(int k) {
        return higher[k];
    }
}
