package org.auvsim.core.reference;

/** Distances of a triangle, given by nine coordinates. */
final class Triangle {
    private Triangle() {}

    /** No gap to a convex part is less than this (m), by a ball about the triangle. */
    static double leastGap(double[] t, Part part) {
        double x = (t[0] + t[3] + t[6]) / 3;
        double y = (t[1] + t[4] + t[7]) / 3;
        double z = (t[2] + t[5] + t[8]) / 3;
        double square = 0;
        for (int k = 0; k < 9; k += 3) {
            double dx = t[k] - x;
            double dy = t[k + 1] - y;
            double dz = t[k + 2] - z;
            square = Math.max(square, dx * dx + dy * dy + dz * dz);
        }
        return part.fromCore(x, y, z) - Math.sqrt(square) - part.radius;
    }

    /** Gap (m) to a convex part; if the cores share a point, minus its radius. */
    static double gap(double[] corners, Part part) {
        double[] v = part.vertices;
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 9; k += 3) {
            least = Math.min(least, part.fromCore(corners[k], corners[k + 1], corners[k + 2]));
        }
        for (int k = 0; k < v.length; k += 3) {
            least = Math.min(least, above(corners, v, k));
        }
        for (int side = 0; side < 9; side += 3) {
            int next = (side + 3) % 9;
            if (part.cutBy(corners, side, next)) {
                least = 0;
            }
            for (int e = 0; e < part.edges.length; e += 2) {
                least =
                        Math.min(
                                least,
                                Segments.distance(
                                        corners,
                                        side,
                                        next,
                                        v,
                                        3 * part.edges[e],
                                        3 * part.edges[e + 1]));
            }
            if (part.edges.length == 0) {
                least = Math.min(least, Segments.ofPoint(v, 0, corners, side, next));
            }
        }
        for (int e = 0; e < part.edges.length; e += 2) {
            if (pierced(corners, v, 3 * part.edges[e], 3 * part.edges[e + 1])) {
                least = 0;
            }
        }
        return least - part.radius;
    }

    /** Distance from the plane of a point that lies over the triangle, else infinity. */
    private static double above(double[] t, double[] v, int k) {
        double[] n = normal(t);
        double d = n[0] * (v[k] - t[0]) + n[1] * (v[k + 1] - t[1]) + n[2] * (v[k + 2] - t[2]);
        double x = v[k] - d * n[0];
        double y = v[k + 1] - d * n[1];
        double z = v[k + 2] - d * n[2];
        return isInside(t, n, x, y, z) ? Math.abs(d) : Double.POSITIVE_INFINITY;
    }

    private static boolean pierced(double[] t, double[] v, int a, int b) {
        double[] n = normal(t);
        double from = n[0] * (v[a] - t[0]) + n[1] * (v[a + 1] - t[1]) + n[2] * (v[a + 2] - t[2]);
        double to = n[0] * (v[b] - t[0]) + n[1] * (v[b + 1] - t[1]) + n[2] * (v[b + 2] - t[2]);
        if (from > 0 == to > 0) {
            return false;
        }
        double s = from / (from - to);
        return isInside(
                t,
                n,
                v[a] + s * (v[b] - v[a]),
                v[a + 1] + s * (v[b + 1] - v[a + 1]),
                v[a + 2] + s * (v[b + 2] - v[a + 2]));
    }

    private static double[] normal(double[] t) {
        double ux = t[3] - t[0];
        double uy = t[4] - t[1];
        double uz = t[5] - t[2];
        double vx = t[6] - t[0];
        double vy = t[7] - t[1];
        double vz = t[8] - t[2];
        double nx = uy * vz - uz * vy;
        double ny = uz * vx - ux * vz;
        double nz = ux * vy - uy * vx;
        double norm = Math.sqrt(nx * nx + ny * ny + nz * nz);
        return new double[] {nx / norm, ny / norm, nz / norm};
    }

    /** Whether a point of its plane lies on the inner side of all three edges. */
    private static boolean isInside(double[] t, double[] n, double x, double y, double z) {
        for (int k = 0; k < 9; k += 3) {
            int next = (k + 3) % 9;
            double ex = t[next] - t[k];
            double ey = t[next + 1] - t[k + 1];
            double ez = t[next + 2] - t[k + 2];
            double px = x - t[k];
            double py = y - t[k + 1];
            double pz = z - t[k + 2];
            double side =
                    n[0] * (ey * pz - ez * py)
                            + n[1] * (ez * px - ex * pz)
                            + n[2] * (ex * py - ey * px);
            if (side < 0) {
                return false;
            }
        }
        return true;
    }
}
