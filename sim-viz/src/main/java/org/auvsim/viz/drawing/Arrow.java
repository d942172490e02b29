package org.auvsim.viz.drawing;

/** Paints arrows: a thin tube and a cone for its head. */
final class Arrow {
    private static final double THIN = 0.0016;
    private static final double HEAD = 3.2;
    private static final double HEAD_LENGTH = 9;

    private final Placement place = new Placement();

    /** An arrow from a place (m, world) by a vector (m). */
    void paint(
            double x,
            double y,
            double z,
            double vx,
            double vy,
            double vz,
            int colour,
            Picture picture) {
        double length = Math.sqrt(vx * vx + vy * vy + vz * vz);
        double radius = Math.min(picture.share(THIN), length * 0.05);
        if (!(length > picture.share(THIN) * 2)) {
            return;
        }
        double head = Math.min(radius * HEAD_LENGTH, length / 2);
        double shaft = length - head;
        place.pointing(vx / length, vy / length, vz / length);
        double middle = shaft / 2 / length;
        move(x + vx * middle, y + vy * middle, z + vz * middle);
        picture.brush().tube(place.pose, shaft, radius, colour);
        double base = shaft / length;
        move(x + vx * base, y + vy * base, z + vz * base);
        picture.brush().cone(place.pose, head, radius * HEAD, colour);
    }

    private void move(double x, double y, double z) {
        place.pose.x = x;
        place.pose.y = y;
        place.pose.z = z;
    }
}
