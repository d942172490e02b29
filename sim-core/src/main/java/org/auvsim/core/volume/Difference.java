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

    /** Centre of the first less that of the second. */
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

    void take(Core a, Core b) {
        x = a.x - b.x;
        y = a.y - b.y;
        z = a.z - b.z;
        count = 0;
        generate(a);
        ofFirst = count;
        generate(b);
    }

    private void generate(Core core) {
        for (int i = 0; i < core.dimensions; i++) {
            for (int k = 0; k < 3; k++) {
                generators[3 * count + k] = core.half[i] * core.axes[3 * i + k];
            }
            count++;
        }
    }

    /** How far the difference is beyond the origin along a unit vector; negative if it is not. */
    double gap(double nx, double ny, double nz) {
        double gap = nx * x + ny * y + nz * z;
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
        for (int i = 0; i < count; i++) {
            if (i == ofFirst) {
                ax = wx - x;
                ay = wy - y;
                az = wz - z;
            }
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
        return nx * wx + ny * wy + nz * wz;
    }
}
