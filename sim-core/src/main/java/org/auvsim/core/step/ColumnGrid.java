package org.auvsim.core.step;

import java.util.Arrays;

/**
 * The broad phase: which swept boxes overlap. Space is cut into columns along x, of a square
 * section about three mean boxes wide; a box stands in each column that it touches, and within a
 * column the boxes are sorted and swept along x. Columns are found by a hash of their y and z.
 *
 * <p>A box that would stand in many columns, such as a sea floor's, is kept apart and compared with
 * all others. A box that changes within the frame is chained to its columns anew; it no longer
 * counts where it stood before.
 */
final class ColumnGrid {
    /** Told of two bodies whose boxes overlap, the lower number first. */
    interface Pairs {
        void meet(int a, int b);
    }

    private static final double MEAN_BOXES_WIDE = 3;
    private static final int MOST_COLUMNS = 16;

    /** So many boxes, spread over all, tell how wide the columns are to be. */
    private static final int SAMPLE = 64;

    private static final double OUTERMOST = 1e9;

    /** Boxes that reach beyond this (m) go on for ever. */
    private static final double FAR = 1e300;

    private final double[] box;
    private final int bodies;
    private final int mask;
    private final int[] starts;
    private final int[] fill;
    private int[] listedBody = new int[64];
    private int[] listedColumn = new int[64];
    private int listed;

    /** Greatest extent (m) along x of the boxes in columns. */
    private double widest;

    private int[] entries = new int[16];
    private double[] entryX = new double[16];
    private int[] large = new int[4];
    private int largeCount;
    private double inverseWidth;
    private final int[] columnsOf = new int[MOST_COLUMNS];

    /** How often a box has changed within the frame. */
    private final int[] version;

    private final int[] chain;
    private final int[] chained;
    private final boolean[] isChained;
    private int chainedCount;
    private int[] nodeBody = new int[64];
    private int[] nodeVersion = new int[64];
    private int[] nodeNext = new int[64];
    private int nodes;

    /**
     * Columns for so many boxes.
     *
     * @param box min x, y, z and max x, y, z (m) of box i at 6 i and behind
     * @param version how often box i has changed since {@link #build}
     */
    ColumnGrid(double[] box, int[] version, int bodies) {
        this.box = box;
        this.version = version;
        this.bodies = bodies;
        int size = Integer.highestOneBit(Math.max(4 * bodies, 16) - 1);
        mask = size - 1;
        starts = new int[size + 1];
        fill = new int[size];
        chain = new int[size];
        chained = new int[size];
        isChained = new boolean[size];
        Arrays.fill(chain, -1);
    }

    /** Puts all boxes into columns; each is sorted when it is swept, which comes next. */
    void build() {
        inverseWidth = 1 / (MEAN_BOXES_WIDE * meanExtent());
        forgetChanges();
        listColumns();
        int sum = 0;
        for (int c = 0; c <= mask; c++) {
            starts[c] = sum;
            sum += fill[c];
            fill[c] = starts[c];
        }
        starts[mask + 1] = sum;
        if (entries.length < sum) {
            entries = new int[2 * sum];
            entryX = new double[2 * sum];
        }
        for (int k = 0; k < sum; k++) {
            entries[fill[listedColumn[k]]++] = listedBody[k];
        }
    }

    /** Lists each box with each of its columns and counts how many stand in each. */
    private void listColumns() {
        Arrays.fill(fill, 0);
        largeCount = 0;
        listed = 0;
        widest = 0;
        for (int i = 0; i < bodies; i++) {
            int at = 6 * i;
            int y = cell(box[at + 1]);
            int z = cell(box[at + 2]);
            if (cell(box[at + 4]) == y && cell(box[at + 5]) == z && box[at + 5] < FAR) {
                list(column(y, z), i);
                continue;
            }
            int columns = columns(i);
            if (columns == 0) {
                addLarge(i);
            }
            for (int k = 0; k < columns; k++) {
                list(columnsOf[k], i);
            }
        }
    }

    private void list(int column, int body) {
        widest = Math.max(widest, box[6 * body + 3] - box[6 * body]);
        if (listed == listedBody.length) {
            listedBody = Arrays.copyOf(listedBody, 2 * listed);
            listedColumn = Arrays.copyOf(listedColumn, 2 * listed);
        }
        listedBody[listed] = body;
        listedColumn[listed++] = column;
        fill[column]++;
    }

    /** Sorts a column by the lower x, equal ones by number: insertion, as most is in order. */
    private void sort(int begin, int end) {
        for (int p = begin; p < end; p++) {
            int i = entries[p];
            double x = box[6 * i];
            int at = p;
            while (at > begin && entryX[at - 1] > x) {
                entryX[at] = entryX[at - 1];
                entries[at] = entries[at - 1];
                at--;
            }
            entryX[at] = x;
            entries[at] = i;
        }
    }

    /** The mean edge (m) of some of the boxes, without those that go on for ever. */
    private double meanExtent() {
        double sum = 0;
        int count = 0;
        int step = Math.max(1, bodies / SAMPLE);
        for (int i = 0; i < bodies; i += step) {
            double extent = box[6 * i + 4] - box[6 * i + 1] + box[6 * i + 5] - box[6 * i + 2];
            if (extent < FAR) {
                sum += extent;
                count += 2;
            }
        }
        return count == 0 || sum == 0 ? 1 : sum / count;
    }

    /**
     * Fills {@code columnsOf} with the columns that box i touches, each once; their number, or 0 if
     * they are too many.
     */
    private int columns(int i) {
        int at = 6 * i;
        int y0 = cell(box[at + 1]);
        int z0 = cell(box[at + 2]);
        int y1 = cell(box[at + 4]);
        int z1 = cell(box[at + 5]);
        if (((double) y1 - y0 + 1) * ((double) z1 - z0 + 1) > MOST_COLUMNS
                || !(box[at + 5] < FAR)) {
            return 0;
        }
        int count = 0;
        for (long y = y0; y <= y1; y++) {
            for (long z = z0; z <= z1; z++) {
                int column = column((int) y, (int) z);
                boolean known = false;
                for (int k = 0; k < count; k++) {
                    known |= columnsOf[k] == column;
                }
                if (!known) {
                    columnsOf[count++] = column;
                }
            }
        }
        return count;
    }

    /** The cell of a coordinate (m); the outermost one for all that is farther off. */
    private int cell(double coordinate) {
        double scaled = Math.min(Math.max(coordinate * inverseWidth, -OUTERMOST), OUTERMOST);
        int cut = (int) scaled;
        return scaled < cut ? cut - 1 : cut;
    }

    private int column(int y, int z) {
        int h = y * 0x9E3779B1 + z * 0x85EBCA77;
        h ^= h >>> 15;
        return (h ^ (h >>> 7)) & mask;
    }

    private void addLarge(int i) {
        if (largeCount == large.length) {
            large = Arrays.copyOf(large, 2 * largeCount);
        }
        large[largeCount++] = i;
    }

    /** Number of columns, for those who share the sweep out. */
    int columns() {
        return mask + 1;
    }

    /** Tells all overlapping pairs of columns {@code from} to {@code to - 1}, each pair once. */
    void sweep(int from, int to, Pairs pairs) {
        for (int column = from; column < to; column++) {
            int end = starts[column + 1];
            sort(starts[column], end);
            for (int p = starts[column]; p < end; p++) {
                int a = entries[p];
                double maxX = box[6 * a + 3];
                for (int q = p + 1; q < end && entryX[q] <= maxX; q++) {
                    int b = entries[q];
                    if (overlapSideways(a, b) && isIn(column, a, b)) {
                        pairs.meet(Math.min(a, b), Math.max(a, b));
                    }
                }
            }
        }
    }

    /** Tells the pairs of large boxes with all others, and with each other. */
    void sweepLarge(Pairs pairs) {
        for (int k = 0; k < largeCount; k++) {
            int a = large[k];
            for (int b = 0; b < bodies; b++) {
                if (overlap(6 * a, 6 * b) && (b > a || (b != a && !isLarge(b)))) {
                    pairs.meet(Math.min(a, b), Math.max(a, b));
                }
            }
        }
    }

    private void forgetChanges() {
        for (int k = 0; k < chainedCount; k++) {
            chain[chained[k]] = -1;
            isChained[chained[k]] = false;
        }
        chainedCount = 0;
        nodes = 0;
    }

    /** Box i has changed, and so has its version. */
    void changed(int i) {
        int columns = columns(i);
        if (columns == 0 && !isLarge(i)) {
            addLarge(i);
            Arrays.sort(large, 0, largeCount);
        }
        for (int k = 0; k < columns; k++) {
            chain(columnsOf[k], i);
        }
    }

    private void chain(int column, int i) {
        if (nodes == nodeBody.length) {
            nodeBody = Arrays.copyOf(nodeBody, 2 * nodes);
            nodeVersion = Arrays.copyOf(nodeVersion, 2 * nodes);
            nodeNext = Arrays.copyOf(nodeNext, 2 * nodes);
        }
        if (!isChained[column]) {
            isChained[column] = true;
            chained[chainedCount++] = column;
        }
        nodeBody[nodes] = i;
        nodeVersion[nodes] = version[i];
        nodeNext[nodes] = chain[column];
        chain[column] = nodes++;
    }

    /** Tells all pairs of box i, as it is now, with others, each pair once. */
    void pairsOf(int i, Pairs pairs) {
        for (int k = 0; k < largeCount; k++) {
            meet(i, large[k], pairs);
        }
        int columns = columns(i);
        if (columns == 0) {
            for (int b = 0; b < bodies; b++) {
                if (!isLarge(b)) {
                    meet(i, b, pairs);
                }
            }
            return;
        }
        for (int k = 0; k < columns; k++) {
            pairsIn(columnsOf[k], i, pairs);
        }
    }

    private void pairsIn(int column, int i, Pairs pairs) {
        double maxX = box[6 * i + 3];
        int end = starts[column + 1];
        for (int p = firstAt(column, box[6 * i] - widest); p < end && entryX[p] <= maxX; p++) {
            int b = entries[p];
            if (version[b] == 0 && overlap(6 * i, 6 * b) && isIn(column, i, b) && b != i) {
                pairs.meet(Math.min(i, b), Math.max(i, b));
            }
        }
        int before = -1;
        for (int node = chain[column]; node >= 0; node = nodeNext[node]) {
            int b = nodeBody[node];
            if (nodeVersion[node] != version[b]) {
                unchain(column, before, node);
                continue;
            }
            before = node;
            if (b != i && overlap(6 * i, 6 * b) && isIn(column, i, b) && !isLarge(b)) {
                pairs.meet(Math.min(i, b), Math.max(i, b));
            }
        }
    }

    /** Where the entries of a column begin whose lower x is no less than a coordinate (m). */
    private int firstAt(int column, double x) {
        int low = starts[column];
        int high = starts[column + 1];
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (entryX[middle] < x) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** Takes a node that no longer counts out of its column's chain. */
    private void unchain(int column, int before, int node) {
        if (before < 0) {
            chain[column] = nodeNext[node];
        } else {
            nodeNext[before] = nodeNext[node];
        }
    }

    private void meet(int i, int b, Pairs pairs) {
        if (b != i && overlap(6 * i, 6 * b)) {
            pairs.meet(Math.min(i, b), Math.max(i, b));
        }
    }

    private boolean isLarge(int i) {
        return Arrays.binarySearch(large, 0, largeCount, i) >= 0;
    }

    private boolean overlapSideways(int a, int b) {
        int p = 6 * a;
        int q = 6 * b;
        return box[p + 1] <= box[q + 4]
                && box[q + 1] <= box[p + 4]
                && box[p + 2] <= box[q + 5]
                && box[q + 2] <= box[p + 5];
    }

    private boolean overlap(int p, int q) {
        return box[p] <= box[q + 3]
                && box[q] <= box[p + 3]
                && box[p + 1] <= box[q + 4]
                && box[q + 1] <= box[p + 4]
                && box[p + 2] <= box[q + 5]
                && box[q + 2] <= box[p + 5];
    }

    /** Of the columns that two boxes share, the one of their intersection's lower corner counts. */
    private boolean isIn(int column, int a, int b) {
        int y = cell(Math.max(box[6 * a + 1], box[6 * b + 1]));
        int z = cell(Math.max(box[6 * a + 2], box[6 * b + 2]));
        return column(y, z) == column;
    }
}
