package org.auvsim.core.step;

import java.util.Arrays;
import java.util.function.IntConsumer;

/**
 * The broad phase: which swept boxes overlap. A box stands in each of the {@link Columns} that it
 * touches, and within a column the boxes are sorted and swept along x.
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

    private final double[] box;
    private final int bodies;
    private final Columns columns;
    private final Lanes lanes;
    private final Listing[] listings;
    private final int[][] fills;
    private final IntConsumer list = this::list;
    private final IntConsumer place = this::place;
    private final int[] starts;

    /** Greatest extent (m) along x of the boxes in columns. */
    private double widest;

    /**
     * What stands in the columns, those of column c from {@code starts[c]} on: 32 bits that order
     * the lower x, then 32 of the box's number.
     */
    private long[] entries = new long[16];

    private int[] large = new int[4];
    private int largeCount;
    private final int[] columnsOf = new int[Columns.MOST];

    /** How often a box has changed within the frame. */
    private final int[] version;

    private final ChangedBoxes changes;

    /** The part of the boxes that one lane puts into columns. */
    private static final class Listing {
        /** How many of the part stand in each column; then where in it the next one is put. */
        final int[] fill;

        long[] entries = new long[64];
        int[] column = new int[64];
        int count;
        int[] large = new int[4];
        int largeCount;
        double widest;

        Listing(int columns) {
            fill = new int[columns];
        }

        void clear() {
            Arrays.fill(fill, 0);
            count = 0;
            largeCount = 0;
            widest = 0;
        }

        void makeRoom() {
            if (count + Columns.MOST > column.length) {
                column = Arrays.copyOf(column, 2 * column.length);
                entries = Arrays.copyOf(entries, 2 * entries.length);
            }
        }

        /**
         * Adds an entry of columns that stand behind the others already; where they are few,
         * without a branch: what is written too much does not count.
         */
        void add(long entry, int columns) {
            entries[count] = entry;
            entries[count + 1] = entry;
            entries[count + 2] = entry;
            entries[count + 3] = entry;
            for (int k = 4; k < columns; k++) {
                entries[count + k] = entry;
            }
            count += columns;
        }

        /** Counts what stands in each column. */
        void tally() {
            for (int k = 0; k < count; k++) {
                fill[column[k]]++;
            }
        }

        void addLarge(int i) {
            large = with(large, largeCount++, i);
        }
    }

    /**
     * A grid for so many boxes.
     *
     * @param box min x, y, z and max x, y, z (m) of box i at 6 i and behind
     * @param version how often box i has changed since {@link #build}
     */
    ColumnGrid(double[] box, int[] version, int bodies, Lanes lanes) {
        this.box = box;
        this.version = version;
        this.bodies = bodies;
        this.lanes = lanes;
        columns = new Columns(box, bodies);
        starts = new int[columns.count() + 1];
        changes = new ChangedBoxes(columns.count(), version);
        listings = new Listing[lanes.count()];
        fills = new int[listings.length][];
        for (int lane = 0; lane < listings.length; lane++) {
            listings[lane] = new Listing(columns.count());
            fills[lane] = listings[lane].fill;
        }
    }

    /** Puts all boxes into columns; each is sorted when it is swept, which comes next. */
    void build() {
        columns.fit();
        changes.clear();
        lanes.run(list);
        assignPlaces();
        lanes.run(place);
    }

    /** Lists each box of a lane's part with each of its columns. */
    private void list(int lane) {
        Listing listing = listings[lane];
        listing.clear();
        int end = (int) ((long) bodies * (lane + 1) / listings.length);
        for (int i = (int) ((long) bodies * lane / listings.length); i < end; i++) {
            listing.makeRoom();
            int count = columns.of(i, listing.column, listing.count);
            if (count == 0) {
                listing.addLarge(i);
            } else {
                double x = box[6 * i];
                listing.widest = Math.max(listing.widest, box[6 * i + 3] - x);
                listing.add(entry(x, i), count);
            }
        }
        listing.tally();
    }

    /** Shares the places in the columns out, lane by lane. */
    private void assignPlaces() {
        int sum = 0;
        int end = columns.count();
        for (int c = 0; c < end; c++) {
            starts[c] = sum;
            for (int[] fill : fills) {
                int here = fill[c];
                fill[c] = sum;
                sum += here;
            }
        }
        starts[end] = sum;
        if (entries.length < sum) {
            entries = new long[2 * sum];
        }
        widest = 0;
        largeCount = 0;
        for (Listing listing : listings) {
            widest = Math.max(widest, listing.widest);
            for (int k = 0; k < listing.largeCount; k++) {
                large = with(large, largeCount++, listing.large[k]);
            }
        }
    }

    private void place(int lane) {
        Listing listing = listings[lane];
        for (int k = 0; k < listing.count; k++) {
            entries[listing.fill[listing.column[k]]++] = listing.entries[k];
        }
    }

    /** A number that orders by a coordinate (m) to 20 bits of its mantissa, then by the box. */
    private static long entry(double x, int i) {
        int high = (int) (Double.doubleToRawLongBits(x + 0.0) >> 32);
        int ordered = high ^ ((high >> 31) & Integer.MAX_VALUE);
        return ((long) ordered << 32) | i;
    }

    /** A number that is greater than those of all boxes which begin no later than at x (m). */
    private static long last(double x) {
        return entry(x, 0) | 0xFFFF_FFFFL;
    }

    /** Sorts by insertion, as the boxes of a column are few. */
    private void sort(int begin, int end) {
        for (int p = begin + 1; p < end; p++) {
            long entry = entries[p];
            int at = p;
            while (at > begin && entries[at - 1] > entry) {
                entries[at] = entries[at - 1];
                at--;
            }
            entries[at] = entry;
        }
    }

    private static int[] with(int[] list, int count, int value) {
        int[] room = count < list.length ? list : Arrays.copyOf(list, 2 * count);
        room[count] = value;
        return room;
    }

    /** Number of columns, for those who share the sweep out. */
    int columns() {
        return columns.count();
    }

    /** Tells all overlapping pairs of columns {@code from} to {@code to - 1}, each pair once. */
    void sweep(int from, int to, Pairs pairs) {
        for (int column = from; column < to; column++) {
            int end = starts[column + 1];
            sort(starts[column], end);
            for (int p = starts[column]; p < end - 1; p++) {
                int a = (int) entries[p];
                long last = last(box[6 * a + 3]);
                for (int q = p + 1; q < end && entries[q] <= last; q++) {
                    int b = (int) entries[q];
                    if (overlap(6 * a, 6 * b) && columns.countsIn(column, a, b)) {
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

    /** Box i has changed, and so has its version. */
    void changed(int i) {
        int count = columns.of(i, columnsOf, 0);
        if (count == 0 && !isLarge(i)) {
            large = with(large, largeCount++, i);
            Arrays.sort(large, 0, largeCount);
        }
        for (int k = 0; k < count; k++) {
            changes.add(columnsOf[k], i);
        }
    }

    /** Tells all pairs of box i, as it is now, with others, each pair once. */
    void pairsOf(int i, Pairs pairs) {
        for (int k = 0; k < largeCount; k++) {
            meet(i, large[k], pairs);
        }
        int count = columns.of(i, columnsOf, 0);
        if (count == 0) {
            for (int b = 0; b < bodies; b++) {
                if (!isLarge(b)) {
                    meet(i, b, pairs);
                }
            }
            return;
        }
        for (int k = 0; k < count; k++) {
            pairsIn(columnsOf[k], i, pairs);
        }
    }

    private void pairsIn(int column, int i, Pairs pairs) {
        long last = last(box[6 * i + 3]);
        int end = starts[column + 1];
        int first = firstAt(column, entry(box[6 * i] - widest, 0));
        for (int p = first; p < end && entries[p] <= last; p++) {
            int b = (int) entries[p];
            if (version[b] == 0 && overlap(6 * i, 6 * b) && b != i) {
                meetIn(column, i, b, pairs);
            }
        }
        for (int node = changes.firstIn(column); node >= 0; node = changes.after(node)) {
            int b = changes.box(node);
            if (b != i && overlap(6 * i, 6 * b) && !isLarge(b)) {
                meetIn(column, i, b, pairs);
            }
        }
    }

    private void meetIn(int column, int i, int b, Pairs pairs) {
        if (columns.countsIn(column, i, b)) {
            pairs.meet(Math.min(i, b), Math.max(i, b));
        }
    }

    /** Where the entries of a column begin that are no less than one. */
    private int firstAt(int column, long entry) {
        int low = starts[column];
        int high = starts[column + 1];
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (entries[middle] < entry) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

    private void meet(int i, int b, Pairs pairs) {
        if (b != i && overlap(6 * i, 6 * b)) {
            pairs.meet(Math.min(i, b), Math.max(i, b));
        }
    }

    private boolean isLarge(int i) {
        return Arrays.binarySearch(large, 0, largeCount, i) >= 0;
    }

    private boolean overlap(int p, int q) {
        return box[p] <= box[q + 3]
                && box[q] <= box[p + 3]
                && box[p + 1] <= box[q + 4]
                && box[q + 1] <= box[p + 4]
                && box[p + 2] <= box[q + 5]
                && box[q + 2] <= box[p + 5];
    }
}
