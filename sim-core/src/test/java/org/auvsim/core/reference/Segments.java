package org.auvsim.core.reference;

/** Distances of line segments. */
final class Segments {
    private Segments() {}

    /** Distance (m) of the segments p[a] p[b] and q[c] q[d] (indices of x coordinates). */
    static double distance(double[] p, int a, int b, double[] q, int c, int d) {
        double ux = p[b] - p[a];
        double uy = p[b + 1] - p[a + 1];
        double uz = p[b + 2] - p[a + 2];
        double vx = q[d] - q[c];
        double vy = q[d + 1] - q[c + 1];
        double vz = q[d + 2] - q[c + 2];
        double wx = p[a] - q[c];
        double wy = p[a + 1] - q[c + 1];
        double wz = p[a + 2] - q[c + 2];
        double uu = ux * ux + uy * uy + uz * uz;
        double uv = ux * vx + uy * vy + uz * vz;
        double vv = vx * vx + vy * vy + vz * vz;
        double uw = ux * wx + uy * wy + uz * wz;
        double vw = vx * wx + vy * wy + vz * wz;
        double det = uu * vv - uv * uv;
        double least = Double.POSITIVE_INFINITY;
        if (det > 1e-14 * uu * vv) {
            double s = (uv * vw - vv * uw) / det;
            double t = (uu * vw - uv * uw) / det;
            if (s >= 0 && s <= 1 && t >= 0 && t <= 1) {
                return norm(wx + s * ux - t * vx, wy + s * uy - t * vy, wz + s * uz - t * vz);
            }
        }
        least = Math.min(least, ofPoint(-wx, -wy, -wz, ux, uy, uz, uu));
        least = Math.min(least, ofPoint(vx - wx, vy - wy, vz - wz, ux, uy, uz, uu));
        least = Math.min(least, ofPoint(wx, wy, wz, vx, vy, vz, vv));
        return Math.min(least, ofPoint(wx + ux, wy + uy, wz + uz, vx, vy, vz, vv));
    }

    /** Distance (m) of the point p[k] from the segment q[c] q[d]. */
    static double ofPoint(double[] p, int k, double[] q, int c, int d) {
        double ux = q[d] - q[c];
        double uy = q[d + 1] - q[c + 1];
        double uz = q[d + 2] - q[c + 2];
        return ofPoint(
                p[k] - q[c],
                p[k + 1] - q[c + 1],
                p[k + 2] - q[c + 2],
                ux,
                uy,
                uz,
                ux * ux + uy * uy + uz * uz);
    }

    /** Distance of a point from the segment from the origin along u. */
    private static double ofPoint(
            double x, double y, double z, double ux, double uy, double uz, double uu) {
        double s = Math.clamp((x * ux + y * uy + z * uz) / uu, 0.0, 1.0);
        return norm(x - s * ux, y - s * uy, z - s * uz);
    }

    private static double norm(double x, double y, double z) {
        return Math.sqrt(x * x + y * y + z * z);
    }
}
