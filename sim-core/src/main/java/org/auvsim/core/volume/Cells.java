package org.auvsim.core.volume;

/**
 * The cells of a height map that are no farther than a range from a solid, sideways. Round the grid
 * lies one more row of cells on each side, as wide as it takes: there the surface goes on as high
 * as at the edge.
 */
final class Cells {
    private double spacing;
    private int columns;
    private int rows;

    /** Where the outermost cells end (m). */
    private double west;

    private double east;
    private double south;
    private double north;

    /** First and last cell, along x and y. */
    int firstI;

    int lastI;
    int firstJ;
    int lastJ;

    /** The solid's least and greatest coordinates (m). */
    private final double[] box = new double[6];

    void around(Core core, double range, HeightMap map) {
        spacing = map.spacing();
        columns = map.columns();
        rows = map.row().size();
        core.bounds(box);
        double room = range + spacing;
        west = Math.min(-spacing, box[0] - room);
        south = Math.min(-spacing, box[1] - room);
        east = Math.max(columns * spacing, box[3] + room);
        north = Math.max(rows * spacing, box[4] + room);
        firstI = cell(box[0] - range, columns);
        firstJ = cell(box[1] - range, rows);
        lastI = cell(box[3] + range, columns);
        lastJ = cell(box[4] + range, rows);
    }

    /** The cell at a coordinate: -1 before the grid, size - 1 behind it. */
    private int cell(double place, int size) {
        return (int) Math.max(-1, Math.min(size - 1, Math.floor(place / spacing)));
    }

    /** Where column {@code i} of the grid is (m), the one before and the one behind it too. */
    double x(int i) {
        return i < 0 ? west : i >= columns ? east : i * spacing;
    }

    /** Where row {@code j} of the grid is (m). */
    double y(int j) {
        return j < 0 ? south : j >= rows ? north : j * spacing;
    }

    /** A distance that the solid cannot be nearer to the surface in a cell (m). */
    double leastDistance(int i, int j, HeightMap map) {
        double a = map.sample(i, j);
        double b = map.sample(i + 1, j);
        double c = map.sample(i, j + 1);
        double d = map.sample(i + 1, j + 1);
        double top = Math.max(Math.max(a, b), Math.max(c, d));
        double bottom = Math.min(Math.min(a, b), Math.min(c, d));
        double dx = outside(box[0], box[3], x(i), x(i + 1));
        double dy = outside(box[1], box[4], y(j), y(j + 1));
        double dz = outside(box[2], box[5], bottom, top);
        return Math.sqrt(dx * dx + dy * dy + dz * dz);
    }

    private static double outside(double low, double high, double from, double till) {
        return Math.max(0, Math.max(from - high, low - till));
    }

    /** Turns {@code to} into one of the two triangles of a cell. */
    void triangle(int i, int j, boolean upper, HeightMap map, Triangle to) {
        corner(0, i, j, map, to);
        if (upper) {
            corner(1, i + 1, j + 1, map, to);
            corner(2, i, j + 1, map, to);
        } else {
            corner(1, i + 1, j, map, to);
            corner(2, i + 1, j + 1, map, to);
        }
        to.finish();
    }

    /** Turns {@code to} into the triangle above or below a place. */
    void triangleAt(double x, double y, HeightMap map, Triangle to) {
        int i = cell(x, columns);
        int j = cell(y, rows);
        double a = (x - x(i)) / (x(i + 1) - x(i));
        double b = (y - y(j)) / (y(j + 1) - y(j));
        triangle(i, j, b > a, map, to);
    }

    private void corner(int k, int i, int j, HeightMap map, Triangle to) {
        to.corner(k, i, j, x(i), y(j), map.sample(i, j));
    }
}
