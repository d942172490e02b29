package org.auvsim.core.step;

import java.util.Arrays;

/**
 * The collision sets of a step, and the pairs that share one: each pair once, in order of its
 * numbers, and only if the swept spheres overlap. Reused from step to step.
 */
public final class CollisionSets {
    private final double[] spheres;
    private final Motion motion;
    private int[] members = new int[64];
    private int[] starts = new int[16];
    private int sets;
    private long[] pairs = new long[64];
    private int pairCount;
    private int[] scratch = new int[64];

    CollisionSets(Motion motion) {
        this.motion = motion;
        this.spheres = new double[4 * motion.size()];
    }

    /** Begins a step of length {@code dt} (s): forgets all sets, computes the swept spheres. */
    void begin(double dt) {
        sets = 0;
        pairCount = 0;
        for (int i = 0; i < motion.size(); i++) {
            motion.sweptSphere(i, dt, spheres);
        }
    }

    /** Swept spheres: x, y, z, radius (m) of collidable i at 4 i and behind. */
    public double[] spheres() {
        return spheres;
    }

    /** An array for a partitioner's own use, at least this long; keeps what was in it. */
    int[] scratch(int length) {
        if (scratch.length < length) {
            scratch = Arrays.copyOf(scratch, Math.max(length, 2 * scratch.length));
        }
        return scratch;
    }

    /** Adds the set {@code from[begin]} to {@code from[end - 1]}. */
    public void add(int[] from, int begin, int end) {
        int size = end - begin;
        int start = starts[sets];
        if (members.length < start + size) {
            members = Arrays.copyOf(members, Math.max(start + size, 2 * members.length));
        }
        System.arraycopy(from, begin, members, start, size);
        if (starts.length < sets + 2) {
            starts = Arrays.copyOf(starts, 2 * starts.length);
        }
        starts[++sets] = start + size;
        addPairs(start, start + size);
    }

    /** Counts primitive operations of a partitioner. */
    void count(long operations) {
        motion.count(operations);
    }

    private void addPairs(int begin, int end) {
        for (int a = begin; a < end; a++) {
            for (int b = a + 1; b < end; b++) {
                int i = Math.min(members[a], members[b]);
                int j = Math.max(members[a], members[b]);
                if (spheresOverlap(i, j) && motion.mayCollide(i, j)) {
                    addPair(i, j);
                }
            }
        }
    }

    private boolean spheresOverlap(int i, int j) {
        int a = 4 * i;
        int b = 4 * j;
        double dx = spheres[a] - spheres[b];
        double dy = spheres[a + 1] - spheres[b + 1];
        double dz = spheres[a + 2] - spheres[b + 2];
        double reach = spheres[a + 3] + spheres[b + 3];
        return dx * dx + dy * dy + dz * dz <= reach * reach;
    }

    private void addPair(int i, int j) {
        if (pairCount == pairs.length) {
            pairs = Arrays.copyOf(pairs, 2 * pairCount);
        }
        pairs[pairCount++] = (long) i << 32 | j;
    }

    /** Ends the partitioning: orders the pairs and drops repetitions. */
    void close() {
        Arrays.sort(pairs, 0, pairCount);
        int kept = 0;
        for (int k = 0; k < pairCount; k++) {
            if (k == 0 || pairs[k] != pairs[k - 1]) {
                pairs[kept++] = pairs[k];
            }
        }
        pairCount = kept;
    }

    /** Number of sets. */
    public int count() {
        return sets;
    }

    /** The numbers of the collidables in a set. */
    public int[] set(int index) {
        return Arrays.copyOfRange(members, starts[index], starts[index + 1]);
    }

    /** Number of pairs to examine. */
    public int pairCount() {
        return pairCount;
    }

    /** The lower number of pair {@code k}. */
    public int first(int k) {
        return (int) (pairs[k] >>> 32);
    }

    /** The higher number of pair {@code k}. */
    public int second(int k) {
        return (int) pairs[k];
    }
}
