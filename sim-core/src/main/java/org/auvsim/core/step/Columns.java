package org.auvsim.core.step;

/**
 * Columns along x into which space is cut, of a square section about three mean boxes wide, and
 * which of them a box touches. Columns are numbered so that those which stand close together have
 * numbers close together: 4 by 4 make a tile, and the tiles are numbered along lines that wrap
 * around, as far apart from each other as their number allows (Fibonacci lattice). Columns that
 * stand far from each other may so have the same number.
 */
final class Columns {
    /** A box that touches more columns than these stands in none. */
    static final int MOST = 16;

    private static final double MEAN_BOXES_WIDE = 3;

    /** So many boxes, spread over all, tell how wide the columns are to be. */
    private static final int SAMPLE = 64;

    /** Boxes that reach beyond this (m) go on for ever. */
    private static final double FAR = 1e300;

    private static final double GOLDEN_SECTION = 0.6180339887498949;
    private static final int TILE_BITS = 2;
    private static final int IN_TILE = (1 << TILE_BITS) - 1;

    /** With no less, and so few columns a box, those of a box have different numbers. */
    private static final int LEAST_TILES = 8;

    private final double[] box;
    private final int bodies;
    private final int tileMask;
    private final int tileStride;
    private double inverseWidth;

    /**
     * Columns for so many boxes.
     *
     * @param box min x, y, z and max x, y, z (m) of box i at 6 i and behind
     */
    Columns(double[] box, int bodies) {
        this.box = box;
        this.bodies = bodies;
        int tiles = Math.max(Integer.highestOneBit(2 * bodies) >> (2 * TILE_BITS), LEAST_TILES);
        tileMask = tiles - 1;
        tileStride = (int) (GOLDEN_SECTION * tiles) | 1;
    }

    /** How many numbers there are. */
    int count() {
        return (tileMask + 1) << (2 * TILE_BITS);
    }

    /** Chooses the width of the columns for the boxes as they are now. */
    void fit() {
        inverseWidth = 1 / (MEAN_BOXES_WIDE * meanExtent());
    }

    /** The mean edge (m) of some of the boxes, without those that go on for ever. */
    private double meanExtent() {
        double sum = 0;
        int count = 0;
        int step = (bodies + SAMPLE - 1) / SAMPLE;
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
     * The columns that box i touches, each once.
     *
     * @param to receives their numbers from {@code first} on, and may be written to for {@link
     *     #MOST} places from there
     * @return how many they are, or 0 if they are too many
     */
    int of(int i, int[] to, int first) {
        int at = 6 * i;
        int y0 = cell(box[at + 1]);
        int z0 = cell(box[at + 2]);
        long rows = (long) cell(box[at + 4]) - y0 + 1;
        long columns = (long) cell(box[at + 5]) - z0 + 1;
        if (rows > MOST || columns > MOST || rows * columns > MOST || !(box[at + 5] < FAR)) {
            return 0;
        }
        if (rows <= 2 && columns <= 2) {
            return writeFour(y0, z0, (int) rows, (int) columns, to, first);
        }
        int count = first;
        for (int y = 0; y < rows; y++) {
            for (int z = 0; z < columns; z++) {
                to[count++] = number(y0 + y, z0 + z);
            }
        }
        return count - first;
    }

    /** One, two or four columns without a branch: what is written too much does not count. */
    private int writeFour(int y, int z, int rows, int columns, int[] to, int first) {
        to[first] = number(y, z);
        to[first + 1] = number(y, z + 1);
        to[first + columns] = number(y + 1, z);
        to[first + columns + 1] = number(y + 1, z + 1);
        return rows * columns;
    }

    /** Of the columns that two boxes share, the one of their intersection's lower corner counts. */
    boolean countsIn(int column, int a, int b) {
        int y = cell(Math.max(box[6 * a + 1], box[6 * b + 1]));
        int z = cell(Math.max(box[6 * a + 2], box[6 * b + 2]));
        return number(y, z) == column;
    }

    /** The cell of a coordinate (m); the outermost one for all that is farther off. */
    private int cell(double coordinate) {
        return (int) Math.floor(coordinate * inverseWidth);
    }

    private int number(int y, int z) {
        int tile = ((y >> TILE_BITS) * tileStride + (z >> TILE_BITS)) & tileMask;
        return (tile << (2 * TILE_BITS)) | ((y & IN_TILE) << TILE_BITS) | (z & IN_TILE);
    }
}
