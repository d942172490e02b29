package org.auvsim.core.step;

import java.util.Arrays;

/**
 * Regions of space that have nothing to do with each other in one frame: cells of a coarse grid in
 * which bodies are, joined where one body is in several. The events of one region can so be taken
 * before those of the next, although some are later: a region's bodies fit into a cache, those of a
 * large world do not. A body that collides may leave its cells; should it come into one of another
 * region, they do have to do with each other.
 */
final class Regions {
    /** With fewer bodies, more time is lost by looking for regions than the cache saves. */
    private static final int LEAST_BODIES = 30_000;

    private static final double MEAN_BOXES_WIDE = 10;

    /** So many mean boxes farther than its box a body is hardly ever thrown by a collision. */
    private static final double SLACK = 1;

    /** A box that is in more cells than these is in all of them. */
    private static final long MOST_CELLS = 27;

    /** So many boxes, spread over all, tell how wide the cells are to be. */
    private static final int SAMPLE = 64;

    private static final int BOX = Paths.BOX;
    private static final int NONE = -1;

    /** Bits of a cell's coordinate in its key. */
    private static final int BITS = 21;

    private static final long REACH = 1L << (BITS - 1);

    private final double[] box;
    private final int bodies;
    private final boolean areEnough;
    private double inverseWidth;
    private double slack;
    private boolean areUsed;

    /** The cells that bodies are in: their keys, and the table that finds them. */
    private long[] key = new long[0];

    private int[] parent = new int[0];
    private int[] table = new int[0];
    private int cells;

    /** One of the cells of each body. */
    private final int[] cellOf;

    /**
     * Regions of so many bodies.
     *
     * @param box min x, y, z and max x, y, z (m) of body i at 6 i and behind
     */
    Regions(double[] box, int bodies) {
        this.box = box;
        this.bodies = bodies;
        areEnough = bodies >= LEAST_BODIES;
        cellOf = new int[areEnough ? bodies : 0];
        if (areEnough) {
            key = new long[bodies];
            parent = new int[bodies];
            table = new int[Integer.highestOneBit(bodies) << 3];
        }
    }

    /** Takes all bodies as one region. */
    void clear() {
        areUsed = false;
    }

    /** Finds the regions of the bodies' boxes as they are now, if it is worth it. */
    void find() {
        areUsed = areEnough;
        if (!areEnough) {
            return;
        }
        cells = 0;
        Arrays.fill(table, NONE);
        double extent = meanExtent();
        inverseWidth = 1 / (MEAN_BOXES_WIDE * extent);
        slack = SLACK * extent;
        for (int i = 0; areUsed && i < bodies; i++) {
            areUsed = isSmall(i, slack);
            if (areUsed) {
                cellOf[i] = cell(low(i, 0, slack), low(i, 1, slack), low(i, 2, slack), NONE);
                join(i);
            }
        }
    }

    /** Whether events of one region may be taken after later ones of another. */
    boolean areUsed() {
        return areUsed;
    }

    private double meanExtent() {
        double sum = 0;
        int count = 0;
        int step = (bodies + SAMPLE - 1) / SAMPLE;
        for (int i = 0; i < bodies; i += step) {
            double extent = box[BOX * i + 3] - box[BOX * i];
            if (extent < Double.POSITIVE_INFINITY) {
                sum += extent;
                count++;
            }
        }
        return sum > 0 ? sum / count : 1;
    }

    /** The first cell along an axis of a box that is wider by {@code aside} (m) on each side. */
    private long low(int i, int axis, double aside) {
        return (long) Math.floor((box[BOX * i + axis] - aside) * inverseWidth);
    }

    private long high(int i, int axis, double aside) {
        return (long) Math.floor((box[BOX * i + axis + 3] + aside) * inverseWidth);
    }

    private boolean isSmall(int i, double aside) {
        long all = 1;
        for (int axis = 0; axis < 3; axis++) {
            long low = low(i, axis, aside);
            long high = high(i, axis, aside);
            if (low < -REACH || high >= REACH || high - low >= MOST_CELLS) {
                return false;
            }
            all *= high - low + 1;
        }
        return all <= MOST_CELLS;
    }

    /** Joins all cells that body i may be in. */
    private void join(int i) {
        int root = root(cellOf[i]);
        long x1 = high(i, 0, slack);
        long y1 = high(i, 1, slack);
        long z1 = high(i, 2, slack);
        for (long x = low(i, 0, slack); x <= x1; x++) {
            for (long y = low(i, 1, slack); y <= y1; y++) {
                for (long z = low(i, 2, slack); z <= z1; z++) {
                    int other = root(cell(x, y, z, root));
                    int smaller = Math.min(root, other);
                    parent[Math.max(root, other)] = smaller;
                    root = smaller;
                }
            }
        }
    }

    /**
     * Takes note that the box of body i has changed; its cells belong to its region from now on.
     *
     * @return false if one of them belongs to another region
     */
    boolean staysInside(int i) {
        if (!areUsed) {
            return true;
        }
        if (!isSmall(i, 0)) {
            return false;
        }
        int root = root(cellOf[i]);
        long x1 = high(i, 0, 0);
        long y1 = high(i, 1, 0);
        long z1 = high(i, 2, 0);
        boolean inside = true;
        for (long x = low(i, 0, 0); x <= x1; x++) {
            for (long y = low(i, 1, 0); y <= y1; y++) {
                for (long z = low(i, 2, 0); z <= z1; z++) {
                    inside &= root(cell(x, y, z, root)) == root;
                }
            }
        }
        return inside;
    }

    /** The region of body i: those with smaller numbers come first. */
    int of(int i) {
        return areUsed ? root(cellOf[i]) : 0;
    }

    private int root(int cell) {
        int at = cell;
        while (parent[at] != at) {
            parent[at] = parent[parent[at]];
            at = parent[at];
        }
        return at;
    }

    /** The number of a cell; a new one belongs to a region, or to its own if that is none. */
    private int cell(long x, long y, long z, int region) {
        long wanted = (x + REACH) << (2 * BITS) | (y + REACH) << BITS | (z + REACH);
        int mask = table.length - 1;
        int at = (int) ((wanted * 0x9E3779B97F4A7C15L) >>> 40) & mask;
        while (table[at] != NONE && key[table[at]] != wanted) {
            at = (at + 1) & mask;
        }
        if (table[at] == NONE) {
            add(wanted, at, region);
        }
        return 2 * cells > table.length ? grown(wanted) : table[at];
    }

    private void add(long wanted, int at, int region) {
        if (cells == key.length) {
            key = Arrays.copyOf(key, 2 * cells);
            parent = Arrays.copyOf(parent, 2 * cells);
        }
        key[cells] = wanted;
        parent[cells] = region == NONE ? cells : region;
        table[at] = cells++;
    }

    /** Makes the table twice as large; where the cell that is wanted is in it then. */
    private int grown(long wanted) {
        table = new int[2 * table.length];
        Arrays.fill(table, NONE);
        int mask = table.length - 1;
        int found = NONE;
        for (int c = 0; c < cells; c++) {
            int at = (int) ((key[c] * 0x9E3779B97F4A7C15L) >>> 40) & mask;
            while (table[at] != NONE) {
                at = (at + 1) & mask;
            }
            table[at] = c;
            found = key[c] == wanted ? c : found;
        }
        return found;
    }
}
