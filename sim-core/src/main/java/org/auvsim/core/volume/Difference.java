package org.auvsim.core.volume;

/**
 * The Minkowski difference of two cores, all {@code a - b} of points of the first and the second:
 * the cores' distance is that of the difference from the origin. A box or segment adds its half
 * edges as generators, each taken with + or -.
 */
final class Difference {
    /** Half edges: generator i at 3 i and behind. */
    private final double[] generators = new double[18];

    private int count;
    private int ofFirst;

    /** Where the number of the triangle's corner stands in that of the difference's. */
    private static final int FIRST_CORNER = 6;

    /** Corners of the second, if that is a triangle. */
    private double[] corners = {};

    private boolean hasCorners;

    /** Centre of the first less that of the second; the first's alone if that is a triangle. */
    double x;

    double y;
    double z;

    /** The supporting point that was asked for last. */
    double wx;

    double wy;
    double wz;

    /** The point of the first core that it comes from, less the core's centre. */
    double ax;

    double ay;
    double az;

    /** Which corner of the difference it is. */
    int corner;

    /** Becomes the difference of two cores. */
    void take(Core a, Core b) {
        x = a.x - b.x;
        y = a.y - b.y;
        z = a.z - b.z;
        count = 0;
        generate(a);
        ofFirst = count;
        generate(b);
        hasCorners = false;
    }

    private void generate(Core core) {
        for (int i = 0; i < core.dimensions; i++) {
            for (int k = 0; k < 3; k++) {
                generators[3 * count + k] = core.half[i] * core.axes[3 * i + k];
            }
            count++;
        }
    }

    /** Becomes the difference of a core and a triangle. */
    void take(Core a, Triangle triangle) {
        x = a.x;
        y = a.y;
        z = a.z;
        count = 0;
        generate(a);
        ofFirst = count;
        corners = triangle.corners;
        hasCorners = true;
    }

    /** How far the difference is beyond the origin along a unit vector; negative if it is not. */
    double gap(double nx, double ny, double nz) {
        double gap = nx * x + ny * y + nz * z;
        if (hasCorners) {
            int k = 3 * farthestCorner(nx, ny, nz);
            gap -= nx * corners[k] + ny * corners[k + 1] + nz * corners[k + 2];
        }
        for (int i = 0; i < 3 * count; i += 3) {
            gap -= Math.abs(nx * generators[i] + ny * generators[i + 1] + nz * generators[i + 2]);
        }
        return gap;
    }

    /** Finds the corner that is least far along a vector; returns how far that is. */
    double support(double nx, double ny, double nz) {
        wx = x;
        wy = y;
        wz = z;
        corner = 0;
        for (int i = 0; i < ofFirst; i++) {
            step(i, nx, ny, nz);
        }
        ax = wx - x;
        ay = wy - y;
        az = wz - z;
        for (int i = ofFirst; i < count; i++) {
            step(i, nx, ny, nz);
        }
        if (hasCorners) {
            leaveFarthest(nx, ny, nz);
        }
        return nx * wx + ny * wy + nz * wz;
    }

    private void step(int i, double nx, double ny, double nz) {
        double gx = generators[3 * i];
        double gy = generators[3 * i + 1];
        double gz = generators[3 * i + 2];
        if (nx * gx + ny * gy + nz * gz > 0) {
            wx -= gx;
            wy -= gy;
            wz -= gz;
            corner |= 1 << i;
        } else {
            wx += gx;
            wy += gy;
            wz += gz;
        }
    }

    private void leaveFarthest(double nx, double ny, double nz) {
        int farthest = farthestCorner(nx, ny, nz);
        wx -= corners[3 * farthest];
        wy -= corners[3 * farthest + 1];
        wz -= corners[3 * farthest + 2];
        corner |= farthest << FIRST_CORNER;
    }

    private int farthestCorner(double nx, double ny, double nz) {
        int farthest = 0;
        for (int k = 1; k < 3; k++) {
            if (nx * (corners[3 * k] - corners[3 * farthest])
                            + ny * (corners[3 * k + 1] - corners[3 * farthest + 1])
                            + nz * (corners[3 * k + 2] - corners[3 * farthest + 2])
                    > 0) {
                farthest = k;
            }
        }
        return farthest;
    }

    /** Which corner of the triangle a corner of the difference comes from. */
    static int ofTriangle(int corner) {
        return corner >> FIRST_CORNER;
    }
}
