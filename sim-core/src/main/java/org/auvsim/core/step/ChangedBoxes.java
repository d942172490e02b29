package org.auvsim.core.step;

import java.util.Arrays;

/**
 * The boxes that have changed since the columns were built, chained to the columns in which they
 * stand now. What is chained of a box counts until it changes again.
 */
final class ChangedBoxes {
    private static final int NONE = -1;

    /** How often a box has changed within the frame. */
    private final int[] version;

    /** The first node of each column. */
    private final int[] first;

    private int[] chained = new int[64];
    private int chainedCount;
    private int[] body = new int[64];
    private int[] bodyVersion = new int[64];
    private int[] next = new int[64];
    private int nodes;

    ChangedBoxes(int columns, int[] version) {
        this.version = version;
        first = new int[columns];
        Arrays.fill(first, NONE);
    }

    /** Forgets all changes. */
    void clear() {
        for (int k = 0; k < chainedCount; k++) {
            first[chained[k]] = NONE;
        }
        chainedCount = 0;
        nodes = 0;
    }

    /** Box i stands in a column, as it is now. */
    void add(int column, int i) {
        if (nodes == body.length) {
            body = Arrays.copyOf(body, 2 * nodes);
            bodyVersion = Arrays.copyOf(bodyVersion, 2 * nodes);
            next = Arrays.copyOf(next, 2 * nodes);
        }
        if (first[column] == NONE) {
            note(column);
        }
        body[nodes] = i;
        bodyVersion[nodes] = version[i];
        next[nodes] = first[column];
        first[column] = nodes++;
    }

    /** A column is noted each time that it gets its first node: once too often does no harm. */
    private void note(int column) {
        if (chainedCount == chained.length) {
            chained = Arrays.copyOf(chained, 2 * chainedCount);
        }
        chained[chainedCount++] = column;
    }

    /** The first node of a column that counts, or a negative number. */
    int firstIn(int column) {
        int node = first[column];
        while (node != NONE && isOld(node)) {
            node = next[node];
        }
        first[column] = node;
        return node;
    }

    /** The next node in the column of a node that counts, or a negative number. */
    int after(int node) {
        int following = next[node];
        while (following != NONE && isOld(following)) {
            following = next[following];
        }
        next[node] = following;
        return following;
    }

    private boolean isOld(int node) {
        return bodyVersion[node] != version[body[node]];
    }

    /** The box of a node. */
    int box(int node) {
        return body[node];
    }
}
