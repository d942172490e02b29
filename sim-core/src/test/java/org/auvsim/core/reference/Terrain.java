package org.auvsim.core.reference;

import java.util.Arrays;
import java.util.List;

/**
 * All that lies below a surface of triangles over a square grid, lowered by {@code depth} (m). Each
 * cell is divided from its corner nearest to the origin; beyond its edge the surface goes on as
 * high as there.
 */
final class Terrain implements Solid {
    /** Distances are as exact as that (m). */
    private static final double ROUNDING = 1e-9;

    private final double spacing;

    /** Row by row (m). */
    private final double[][] heights;

    private final double depth;
    private final Placement now = new Placement();

    Terrain(double spacing, double[][] heights) {
        this(spacing, heights, 0);
    }

    private Terrain(double spacing, double[][] heights, double depth) {
        this.spacing = spacing;
        this.heights = heights;
        this.depth = depth;
    }

    @Override
    public double swing() {
        return 0;
    }

    /**
     * Lowered so far that the distance from the old surface is the margin at the steepest place.
     */
    @Override
    public Terrain eroded(double margin) {
        double square = 0;
        for (int j = 1; j < heights.length; j++) {
            for (int i = 1; i < heights[j].length; i++) {
                double alongX = rise(j, i, j, i - 1, j - 1, i, j - 1, i - 1);
                double alongY = rise(j, i, j - 1, i, j, i - 1, j - 1, i - 1);
                square = Math.max(square, alongX * alongX + alongY * alongY);
            }
        }
        return new Terrain(spacing, heights, depth + margin * Math.sqrt(1 + square));
    }

    /** The steeper of two edges: from (b, a) to (d, c) and from (f, e) to (h, g). */
    private double rise(int b, int a, int d, int c, int f, int e, int h, int g) {
        return Math.max(
                        Math.abs(heights[b][a] - heights[d][c]),
                        Math.abs(heights[f][e] - heights[h][g]))
                / spacing;
    }

    @Override
    public void follow(Placement body) {
        System.arraycopy(body.at, 0, now.at, 0, 3);
        System.arraycopy(body.turn, 0, now.turn, 0, 9);
    }

    @Override
    public List<Part> parts() {
        throw new UnsupportedOperationException("the ground meets parts and has none");
    }

    private double sample(int i, int j) {
        double[] row = heights[Math.clamp(j, 0, heights.length - 1)];
        return row[Math.clamp(i, 0, row.length - 1)] - depth;
    }

    @Override
    public double gapTo(Part part) {
        double[] middle = part.middle();
        double x = now.inward(0, middle[0], middle[1], middle[2]);
        double y = now.inward(1, middle[0], middle[1], middle[2]);
        double z = now.inward(2, middle[0], middle[1], middle[2]);
        double near = part.reach() + Union.WIDE;
        int i0 = (int) Math.floor((x - near) / spacing);
        int i1 = (int) Math.floor((x + near) / spacing);
        int j0 = (int) Math.floor((y - near) / spacing);
        int j1 = (int) Math.floor((y + near) / spacing);
        double highest = Double.NEGATIVE_INFINITY;
        for (int i = i0; i <= i1 + 1; i++) {
            for (int j = j0; j <= j1 + 1; j++) {
                highest = Math.max(highest, sample(i, j));
            }
        }
        if (z - part.reach() - highest > Union.WIDE) {
            return Union.WIDE;
        }
        if (z <= height(x, y)) {
            return -1;
        }
        int under = (int) Math.floor(x / spacing);
        int beside = (int) Math.floor(y / spacing);
        double least = cell(part, under, beside, Union.WIDE);
        for (int i = i0; i <= i1; i++) {
            for (int j = j0; j <= j1; j++) {
                if (fromBox(x, y, z, i, j) - part.reach() < least) {
                    least = cell(part, i, j, least);
                }
            }
        }
        return least;
    }

    /** No point of a cell is nearer to a point than this (m). */
    private double fromBox(double x, double y, double z, int i, int j) {
        double[] corners = {sample(i, j), sample(i + 1, j), sample(i, j + 1), sample(i + 1, j + 1)};
        double low = Arrays.stream(corners).min().orElseThrow();
        double high = Arrays.stream(corners).max().orElseThrow();
        double alongX = beyond(x, i * spacing, (i + 1) * spacing);
        double alongY = beyond(y, j * spacing, (j + 1) * spacing);
        double alongZ = beyond(z, low, high);
        return Math.sqrt(alongX * alongX + alongY * alongY + alongZ * alongZ) - ROUNDING;
    }

    private static double beyond(double at, double low, double high) {
        return Math.max(0, Math.max(low - at, at - high));
    }

    private double height(double x, double y) {
        int i = (int) Math.floor(x / spacing);
        int j = (int) Math.floor(y / spacing);
        double u = x / spacing - i;
        double v = y / spacing - j;
        double near = sample(i, j);
        double far = sample(i + 1, j + 1);
        double side = u >= v ? sample(i + 1, j) : sample(i, j + 1);
        double less = Math.min(u, v);
        double more = Math.max(u, v);
        return near + more * (side - near) + less * (far - side);
    }

    /** Gap to the two triangles of a cell, or one that is less. */
    private double cell(Part part, int i, int j, double less) {
        double[] corners = new double[9];
        corner(i, j, corners, 0);
        corner(i + 1, j + 1, corners, 3);
        corner(i + 1, j, corners, 6);
        double least = triangle(corners, part, less);
        corner(i, j + 1, corners, 6);
        return triangle(corners, part, least);
    }

    private static double triangle(double[] corners, Part part, double less) {
        return Triangle.leastGap(corners, part) - ROUNDING < less
                ? Math.min(less, Triangle.gap(corners, part))
                : less;
    }

    private void corner(int i, int j, double[] to, int offset) {
        now.outward(i * spacing, j * spacing, sample(i, j), to, offset);
    }
}
