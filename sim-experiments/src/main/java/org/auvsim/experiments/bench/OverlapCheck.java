package org.auvsim.experiments.bench;

import java.util.Arrays;

/**
 * How deep equal spheres are in one another, found without any of the simulator's own geometry: a
 * hashed grid with cells of a diameter, in which each sphere looks at its own cell and those about.
 */
public final class OverlapCheck {
    private final double radius;
    private final int[] heads;
    private final int[] next;

    /** For so many spheres of a radius (m). */
    public OverlapCheck(int spheres, double radius) {
        this.radius = radius;
        heads = new int[Integer.highestOneBit(Math.max(1, spheres)) * 4];
        next = new int[spheres];
    }

    /**
     * The largest overlap of two spheres, in radii: 0 where none overlap, 2 where two centres are
     * at one place.
     *
     * @param centres x, y, z (m) of sphere i at 3 i and behind
     */
    public double largest(double[] centres) {
        Arrays.fill(heads, -1);
        double nearest = 4 * radius * radius;
        for (int i = 0; i < next.length; i++) {
            nearest = Math.min(nearest, nearestAbout(centres, i));
            int cell =
                    slot(cell(centres[3 * i]), cell(centres[3 * i + 1]), cell(centres[3 * i + 2]));
            next[i] = heads[cell];
            heads[cell] = i;
        }
        return ofDistance(Math.sqrt(nearest), radius);
    }

    /**
     * The overlap, in radii, of two spheres with centres at a distance (m); 0 if they are apart.
     */
    static double ofDistance(double distance, double radius) {
        return Math.max(0, 2 - distance / radius);
    }

    /** Square of the distance (m^2) to the nearest of those that are in the grid and near. */
    private double nearestAbout(double[] centres, int i) {
        long x = cell(centres[3 * i]);
        long y = cell(centres[3 * i + 1]);
        long z = cell(centres[3 * i + 2]);
        double nearest = Double.POSITIVE_INFINITY;
        for (long cx = x - 1; cx <= x + 1; cx++) {
            for (long cy = y - 1; cy <= y + 1; cy++) {
                for (long cz = z - 1; cz <= z + 1; cz++) {
                    nearest = Math.min(nearest, nearestIn(slot(cx, cy, cz), centres, i));
                }
            }
        }
        return nearest;
    }

    private double nearestIn(int slot, double[] centres, int i) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int j = heads[slot]; j >= 0; j = next[j]) {
            double dx = centres[3 * i] - centres[3 * j];
            double dy = centres[3 * i + 1] - centres[3 * j + 1];
            double dz = centres[3 * i + 2] - centres[3 * j + 2];
            nearest = Math.min(nearest, dx * dx + dy * dy + dz * dz);
        }
        return nearest;
    }

    private long cell(double coordinate) {
        return (long) Math.floor(coordinate / (2 * radius));
    }

    /** Cells that fall together by chance cost time alone: distances are compared anyway. */
    private int slot(long x, long y, long z) {
        long h = x * 0x9E3779B97F4A7C15L + y * 0xC2B2AE3D27D4EB4FL + z * 0x165667B19E3779F9L;
        long mixed = (h ^ (h >>> 29)) * 0xBF58476D1CE4E5B9L;
        return (int) (mixed >>> 33) & (heads.length - 1);
    }
}
