package org.auvsim.core.volume;

/** Rotation matrices of unit quaternions, one element at a time: nothing is allocated. */
final class Turn {
    private Turn() {}

    private static double element(int row, int column, double w, double x, double y, double z) {
        return switch (3 * row + column) {
            case 0 -> 1 - 2 * (y * y + z * z);
            case 1 -> 2 * (x * y - w * z);
            case 2 -> 2 * (x * z + w * y);
            case 3 -> 2 * (x * y + w * z);
            case 4 -> 1 - 2 * (x * x + z * z);
            case 5 -> 2 * (y * z - w * x);
            case 6 -> 2 * (x * z - w * y);
            case 7 -> 2 * (y * z + w * x);
            default -> 1 - 2 * (x * x + y * y);
        };
    }

    /** Component {@code k} (0 to 2) of a turned vector. */
    static double component(
            int k, double vx, double vy, double vz, double w, double x, double y, double z) {
        return element(k, 0, w, x, y, z) * vx
                + element(k, 1, w, x, y, z) * vy
                + element(k, 2, w, x, y, z) * vz;
    }

    /** Component {@code k} (0 to 2) of a vector that is turned back. */
    static double componentBack(
            int k, double vx, double vy, double vz, double w, double x, double y, double z) {
        return component(k, vx, vy, vz, w, -x, -y, -z);
    }
}
