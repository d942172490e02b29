package org.auvsim.auvsml.document;

import org.auvsim.core.field.GriddedCurrent;
import org.auvsim.core.math.Numbers;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/** The points of a file, put in the order of a grid. */
final class Grid {
    private static final int AXES = 3;

    private final Path file;
    private final List<GridRow> rows;
    private final double[][] axes = new double[AXES][];

    Grid(Path file, List<GridRow> rows) {
        this.file = file;
        for (int axis = 0; axis < AXES; axis++) {
            int column = axis;
            axes[axis] =
                    rows.stream().mapToDouble(r -> r.get(column)).sorted().distinct().toArray();
        }
        this.rows = rows.stream().sorted(Comparator.comparingLong(this::point)).toList();
    }

    /** The number of a row's point, x changing first, z last. */
    private long point(GridRow row) {
        return (index(row, 2) * axes[1].length + index(row, 1)) * axes[0].length + index(row, 0);
    }

    private long index(GridRow row, int axis) {
        return Arrays.binarySearch(axes[axis], row.get(axis));
    }

    /**
     * The current with these numbers in place of its file.
     *
     * @throws GridFileException if a point is missing, or there twice
     */
    GriddedCurrent current(GriddedCurrent current) throws GridFileException {
        requireComplete();
        return new GriddedCurrent(
                current.id(),
                current.name(),
                Numbers.of(axes[0]),
                Numbers.of(axes[1]),
                Numbers.of(axes[2]),
                column(3),
                column(4),
                column(5));
    }

    private Numbers column(int column) {
        return Numbers.of(rows.stream().mapToDouble(row -> row.get(column)).toArray());
    }

    private void requireComplete() throws GridFileException {
        long points = (long) axes[0].length * axes[1].length * axes[2].length;
        for (int k = 0; k < rows.size(); k++) {
            if (point(rows.get(k)) < k) {
                throw twice(rows.get(k - 1), rows.get(k));
            }
            if (point(rows.get(k)) > k) {
                throw hole(k);
            }
        }
        if (rows.size() < points) {
            throw hole(rows.size());
        }
    }

    private GridFileException twice(GridRow one, GridRow other) {
        long earlier = Math.min(one.line(), other.line());
        long later = Math.max(one.line(), other.line());
        return new GridFileException(
                "%s:%d: the point %s is in line %d already"
                        .formatted(file, later, one.place(), earlier));
    }

    private GridFileException hole(long point) {
        int x = (int) (point % axes[0].length);
        int y = (int) (point / axes[0].length % axes[1].length);
        int z = (int) (point / axes[0].length / axes[1].length);
        return new GridFileException(
                "%s has a hole: no row has the point (%s, %s, %s) of its %d x %d x %d points"
                        .formatted(
                                file,
                                axes[0][x],
                                axes[1][y],
                                axes[2][z],
                                axes[0].length,
                                axes[1].length,
                                axes[2].length));
    }
}
