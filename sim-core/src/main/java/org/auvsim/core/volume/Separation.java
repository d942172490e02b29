package org.auvsim.core.volume;

/**
 * How far two volumes are from each other, and where. Mutable and with room to calculate in: each
 * thread has its own and uses it again and again.
 */
public final class Separation {
    /** Gap between the surfaces (m); 0 or less if the volumes share a point. */
    public double distance;

    /** Unit normal (world) from the second volume to the first. */
    public double nx;

    public double ny;
    public double nz;

    /** Midpoint (m, world) of the two points that are nearest to each other. */
    public double px;

    public double py;
    public double pz;

    /** Room for the two solids that are compared. */
    final Core first = new Core();

    final Core second = new Core();

    /** Room for a triangle of a height map, and the cells that it comes from. */
    final Triangle triangle = new Triangle();

    final Cells cells = new Cells();

    /** The first volume's pose as the second sees it. */
    final Pose seen = new Pose();

    /** What measures boxes. */
    final Polytopes polytopes = new Polytopes();

    private double keptDistance;
    private double keptNx;
    private double keptNy;
    private double keptNz;
    private double keptPx;
    private double keptPy;
    private double keptPz;

    /** Keeps a result that any other is less than. */
    void keepFarthest() {
        keptDistance = Double.POSITIVE_INFINITY;
    }

    double keptDistance() {
        return keptDistance;
    }

    double keptNx() {
        return keptNx;
    }

    double keptNy() {
        return keptNy;
    }

    double keptNz() {
        return keptNz;
    }

    /** Keeps this result if its distance is less than that of the kept one. */
    void keepIfLess() {
        if (distance < keptDistance) {
            keptDistance = distance;
            keptNx = nx;
            keptNy = ny;
            keptNz = nz;
            keptPx = px;
            keptPy = py;
            keptPz = pz;
        }
    }

    /** Takes the kept result. */
    void restoreKept() {
        distance = keptDistance;
        nx = keptNx;
        ny = keptNy;
        nz = keptNz;
        px = keptPx;
        py = keptPy;
        pz = keptPz;
    }

    /** Turns a result in the coordinates of a pose into one in the world's. */
    void toWorld(Pose pose) {
        double x = pose.toWorld(0, px, py, pz) + pose.x;
        double y = pose.toWorld(1, px, py, pz) + pose.y;
        pz = pose.toWorld(2, px, py, pz) + pose.z;
        px = x;
        py = y;
        double n = pose.toWorld(0, nx, ny, nz);
        double m = pose.toWorld(1, nx, ny, nz);
        nz = pose.toWorld(2, nx, ny, nz);
        nx = n;
        ny = m;
    }

    /** The same with first and second volume exchanged. */
    void flip() {
        nx = -nx;
        ny = -ny;
        nz = -nz;
    }

    void normal(double x, double y, double z) {
        nx = x;
        ny = y;
        nz = z;
    }

    /**
     * Completes the result from that of the cores, whose normal is already here: their distance and
     * the point of the first core that is nearest to the second.
     */
    void swell(double cores, double radiusA, double radiusB, double x, double y, double z) {
        distance = cores - radiusA - radiusB;
        double back = radiusA + distance / 2;
        px = x - nx * back;
        py = y - ny * back;
        pz = z - nz * back;
    }
}
