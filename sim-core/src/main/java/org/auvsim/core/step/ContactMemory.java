package org.auvsim.core.step;

import org.auvsim.core.volume.Manifold;

import java.util.Arrays;

/**
 * What a world remembers of its contacts from step to step: when a pair last hit, for the rule that
 * tells a bounce from a long touch, and the forces of resting contacts, from which the solver
 * starts the next time. It is part of the world's state and copied with it.
 */
public final class ContactMemory {
    /** Numbers a point: where it is on the first body (m, its axes), normal force, friction (N). */
    private static final int POINT = 7;

    private static final int ENTRY = POINT * Manifold.MAXIMUM;

    /** Pairs that have not met for so long (s) are forgotten. */
    private static final double FORGET = 1;

    private int count;
    private long[] pair;
    private double[] lastHit;
    private double[] lastUse;
    private int[] repeats;
    private int[] points;
    private double[] forces;
    private int[] table;

    /** What hits have changed: whose they were, and what was remembered before. */
    private int hits;

    private long[] hitPair = new long[16];
    private double[] hitBefore = new double[16];
    private int[] repeatsBefore = new int[16];

    /** Remembers nothing. */
    public ContactMemory() {
        pair = new long[16];
        lastHit = new double[16];
        lastUse = new double[16];
        repeats = new int[16];
        points = new int[16];
        forces = new double[16 * ENTRY];
        table = new int[64];
        Arrays.fill(table, -1);
    }

    /** An independent copy. */
    public ContactMemory copy() {
        ContactMemory copy = new ContactMemory();
        copy.count = count;
        copy.pair = pair.clone();
        copy.lastHit = lastHit.clone();
        copy.lastUse = lastUse.clone();
        copy.repeats = repeats.clone();
        copy.points = points.clone();
        copy.forces = forces.clone();
        copy.table = table.clone();
        return copy;
    }

    /** Forgets everything, as when bodies change their places in the world's arrays. */
    public void clear() {
        count = 0;
        Arrays.fill(table, -1);
    }

    /**
     * The entry of a pair at a time (s, world), made if there is none; valid until the next call.
     */
    int entry(int a, int b, double time) {
        long key = (long) a << 32 | b;
        int at = place(key);
        if (table[at] < 0) {
            if (count == pair.length) {
                makeRoom(time);
                at = place(key);
            }
            pair[count] = key;
            lastHit[count] = Double.NEGATIVE_INFINITY;
            repeats[count] = 0;
            points[count] = 0;
            table[at] = count++;
        }
        lastUse[table[at]] = time;
        return table[at];
    }

    private int place(long key) {
        long h = key * 0x9E3779B97F4A7C15L;
        int at = (int) (h >>> 40) & (table.length - 1);
        while (table[at] >= 0 && pair[table[at]] != key) {
            at = (at + 1) & (table.length - 1);
        }
        return at;
    }

    /** Drops what is old; grows if that is not half of it. */
    private void makeRoom(double time) {
        int kept = 0;
        for (int k = 0; k < count; k++) {
            if (lastUse[k] >= time - FORGET) {
                move(k, kept++);
            }
        }
        count = kept;
        if (2 * count > pair.length) {
            int capacity = 2 * pair.length;
            pair = Arrays.copyOf(pair, capacity);
            lastHit = Arrays.copyOf(lastHit, capacity);
            lastUse = Arrays.copyOf(lastUse, capacity);
            repeats = Arrays.copyOf(repeats, capacity);
            points = Arrays.copyOf(points, capacity);
            forces = Arrays.copyOf(forces, capacity * ENTRY);
            table = new int[4 * capacity];
        }
        Arrays.fill(table, -1);
        for (int k = 0; k < count; k++) {
            table[place(pair[k])] = k;
        }
    }

    private void move(int from, int to) {
        pair[to] = pair[from];
        lastHit[to] = lastHit[from];
        lastUse[to] = lastUse[from];
        repeats[to] = repeats[from];
        points[to] = points[from];
        System.arraycopy(forces, from * ENTRY, forces, to * ENTRY, ENTRY);
    }

    /** When the pair last hit (s, world); minus infinity if never. */
    double lastHit(int entry) {
        return lastHit[entry];
    }

    int repeats(int entry) {
        return repeats[entry];
    }

    /** From now on hits can be taken back. */
    void mark() {
        hits = 0;
    }

    /** Takes back the hits since {@link #mark}, the last one first. */
    void rewind() {
        while (hits > 0) {
            int at = place(hitPair[--hits]);
            if (table[at] >= 0) {
                lastHit[table[at]] = hitBefore[hits];
                repeats[table[at]] = repeatsBefore[hits];
            }
        }
    }

    void hit(int entry, double time, int repeated) {
        if (hits == hitPair.length) {
            hitPair = Arrays.copyOf(hitPair, 2 * hits);
            hitBefore = Arrays.copyOf(hitBefore, 2 * hits);
            repeatsBefore = Arrays.copyOf(repeatsBefore, 2 * hits);
        }
        hitPair[hits] = pair[entry];
        hitBefore[hits] = lastHit[entry];
        repeatsBefore[hits++] = repeats[entry];
        lastHit[entry] = time;
        repeats[entry] = repeated;
    }

    void clearPoints(int entry) {
        points[entry] = 0;
    }

    /** Adds a contact point of the pair with its force (N, world) on the first body. */
    void addPoint(
            int entry, double x, double y, double z, double fn, double fx, double fy, double fz) {
        int at = entry * ENTRY + POINT * points[entry]++;
        forces[at] = x;
        forces[at + 1] = y;
        forces[at + 2] = z;
        forces[at + 3] = fn;
        forces[at + 4] = fx;
        forces[at + 5] = fy;
        forces[at + 6] = fz;
    }

    /**
     * Where in {@link #force} the point of the pair stands that is nearest to a place on the first
     * body, if it is within a distance (m); else -1.
     */
    int nearest(int entry, double x, double y, double z, double within) {
        int best = -1;
        double least = within * within;
        for (int k = 0; k < points[entry]; k++) {
            int at = entry * ENTRY + POINT * k;
            double dx = forces[at] - x;
            double dy = forces[at + 1] - y;
            double dz = forces[at + 2] - z;
            double squared = dx * dx + dy * dy + dz * dz;
            if (squared <= least) {
                least = squared;
                best = at + 3;
            }
        }
        return best;
    }

    /** A number of a remembered force: normal (N), then friction's x, y, z (N, world). */
    double force(int index) {
        return forces[index];
    }
}
