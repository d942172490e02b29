package org.auvsim.core.volume;

import java.util.Arrays;

/**
 * The points where two volumes touch or nearly touch. Mutable and with room to calculate in: each
 * thread has its own and uses it again and again.
 */
public final class Manifold {
    /** The greatest number of points that are kept. */
    public static final int MAXIMUM = 8;

    /** How many points there are. */
    public int count;

    /** Points (m, world), halfway between the two surfaces. */
    public final double[] x = new double[MAXIMUM];

    public final double[] y = new double[MAXIMUM];
    public final double[] z = new double[MAXIMUM];

    /** Unit normals (world) from the second volume to the first. */
    public final double[] nx = new double[MAXIMUM];

    public final double[] ny = new double[MAXIMUM];
    public final double[] nz = new double[MAXIMUM];

    /** Gap between the surfaces at the point, along the normal (m); negative where they overlap. */
    public final double[] gap = new double[MAXIMUM];

    /** Room for the nearest points of the two. */
    final Separation nearest = new Separation();

    /** What finds the points where boxes lie on each other. */
    final FaceClip face = new FaceClip();

    /** Removes all points. */
    public void clear() {
        count = 0;
    }

    /**
     * Adds a point. If there are already {@link #MAXIMUM}, the deepest one stays, and of the others
     * that one goes which is nearest to another.
     */
    public void add(double x, double y, double z, double nx, double ny, double nz, double gap) {
        if (count < MAXIMUM) {
            put(count++, x, y, z, nx, ny, nz, gap);
            return;
        }
        int least = mostCrowded(x, y, z, gap);
        if (least >= 0) {
            put(least, x, y, z, nx, ny, nz, gap);
        }
    }

    private void put(
            int i, double x, double y, double z, double nx, double ny, double nz, double gap) {
        this.x[i] = x;
        this.y[i] = y;
        this.z[i] = z;
        this.nx[i] = nx;
        this.ny[i] = ny;
        this.nz[i] = nz;
        this.gap[i] = gap;
    }

    /** The point to give up for a new one; -1 for the new one itself. */
    private int mostCrowded(double px, double py, double pz, double newGap) {
        int deepest = deepest();
        boolean newIsDeepest = newGap < gap[deepest];
        int least = newIsDeepest ? 0 : -1;
        double room = newIsDeepest ? Double.POSITIVE_INFINITY : roomAt(px, py, pz, -1);
        for (int i = 0; i < MAXIMUM; i++) {
            if (i == deepest && !newIsDeepest) {
                continue;
            }
            double own = Math.min(roomAt(x[i], y[i], z[i], i), squared(i, px, py, pz));
            if (own < room) {
                room = own;
                least = i;
            }
        }
        return least;
    }

    /** Squared distance to the nearest of the other points. */
    private double roomAt(double px, double py, double pz, int self) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            if (i != self) {
                least = Math.min(least, squared(i, px, py, pz));
            }
        }
        return least;
    }

    private double squared(int i, double px, double py, double pz) {
        double dx = x[i] - px;
        double dy = y[i] - py;
        double dz = z[i] - pz;
        return dx * dx + dy * dy + dz * dz;
    }

    /** The point with the least gap, the first of them; -1 without points. */
    int deepest() {
        int deepest = -1;
        for (int i = 0; i < count; i++) {
            if (deepest < 0 || gap[i] < gap[deepest]) {
                deepest = i;
            }
        }
        return deepest;
    }

    /** The least gap (m); infinite without points. */
    public double leastGap() {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            least = Math.min(least, gap[i]);
        }
        return least;
    }

    /** Turns points in the coordinates of a pose into the world's. */
    void toWorld(Pose pose) {
        for (int i = 0; i < count; i++) {
            nearest.px = x[i];
            nearest.py = y[i];
            nearest.pz = z[i];
            nearest.normal(nx[i], ny[i], nz[i]);
            nearest.toWorld(pose);
            put(i, nearest.px, nearest.py, nearest.pz, nearest.nx, nearest.ny, nearest.nz, gap[i]);
        }
    }

    /** The same with first and second volume exchanged. */
    void flip() {
        for (int i = 0; i < count; i++) {
            nx[i] = -nx[i];
            ny[i] = -ny[i];
            nz[i] = -nz[i];
        }
    }

    /** Adds the point of the nearest distance. */
    void add(Separation s) {
        add(s.px, s.py, s.pz, s.nx, s.ny, s.nz, s.distance);
    }

    @Override
    public String toString() {
        return count + " points, gaps " + Arrays.toString(Arrays.copyOf(gap, count));
    }
}
