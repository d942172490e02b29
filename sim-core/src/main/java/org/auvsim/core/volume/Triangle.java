package org.auvsim.core.volume;

/** A triangle of a height map's surface, in the map's coordinates; its corners and its normal. */
final class Triangle {
    /** Corner k at 3 k and behind (m); counterclockwise as seen from above. */
    final double[] corners = new double[9];

    /** Places of the corners in the grid: i and j of corner k at 2 k and 2 k + 1. */
    final int[] places = new int[6];

    /** Unit normal, upward. */
    double nx;

    double ny;
    double nz;

    /** Corner {@code k} as a place of the grid and a point. */
    void corner(int k, int i, int j, double x, double y, double z) {
        places[2 * k] = i;
        places[2 * k + 1] = j;
        corners[3 * k] = x;
        corners[3 * k + 1] = y;
        corners[3 * k + 2] = z;
    }

    /** Finds the normal of the corners. */
    void finish() {
        double ex = corners[3] - corners[0];
        double ey = corners[4] - corners[1];
        double ez = corners[5] - corners[2];
        double fx = corners[6] - corners[0];
        double fy = corners[7] - corners[1];
        double fz = corners[8] - corners[2];
        double x = ey * fz - ez * fy;
        double y = ez * fx - ex * fz;
        double z = ex * fy - ey * fx;
        double length = Math.sqrt(x * x + y * y + z * z);
        nx = x / length;
        ny = y / length;
        nz = z / length;
    }

    /** Height of a point above the triangle's plane, along the normal (m). */
    double height(double x, double y, double z) {
        return (x - corners[0]) * nx + (y - corners[1]) * ny + (z - corners[2]) * nz;
    }

    /**
     * The gap to a solid across two planes with this unit normal, no more than the distance (m).
     */
    double gap(Core core, double x, double y, double z) {
        double top = x * corners[0] + y * corners[1] + z * corners[2];
        top = Math.max(top, x * corners[3] + y * corners[4] + z * corners[5]);
        top = Math.max(top, x * corners[6] + y * corners[7] + z * corners[8]);
        double centre = x * core.x + y * core.y + z * core.z;
        return centre - top - core.along(x, y, z) - core.radius;
    }

    /** Whether the foot of a point's perpendicular on the plane is in the triangle. */
    boolean isBelow(double x, double y, double z) {
        return isInsideEdge(0, 3, x, y, z)
                && isInsideEdge(3, 6, x, y, z)
                && isInsideEdge(6, 0, x, y, z);
    }

    private boolean isInsideEdge(int from, int to, double x, double y, double z) {
        double ex = corners[to] - corners[from];
        double ey = corners[to + 1] - corners[from + 1];
        double ez = corners[to + 2] - corners[from + 2];
        double dx = x - corners[from];
        double dy = y - corners[from + 1];
        double dz = z - corners[from + 2];
        return (ey * dz - ez * dy) * nx + (ez * dx - ex * dz) * ny + (ex * dy - ey * dx) * nz >= 0;
    }
}
