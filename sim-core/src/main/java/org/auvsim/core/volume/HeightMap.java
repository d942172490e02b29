package org.auvsim.core.volume;

import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Numbers;
import org.auvsim.core.math.Vec3;

import java.util.List;

/**
 * All that is not above a surface given by heights (z) on a square grid over x and y: the sea
 * floor. Row j has y = j times the spacing, height i of a row x = i times the spacing. A cell
 * between four heights is two triangles, divided from its corner nearest to the origin to the
 * opposite one. Beyond its edges the surface goes on as high as at the edge. For fixed objects.
 *
 * @param spacing of the heights (m) along x and y
 */
public record HeightMap(@Unit("m") double spacing, List<Row> row) implements Volume {
    /** Heights (m) along x. */
    public record Row(@Unit("m") Numbers heights) {}

    /**
     * A checked map.
     *
     * @throws IllegalArgumentException if the spacing is not positive and finite, there are fewer
     *     than 2 x 2 heights, a row is shorter or longer than the first, or a height is not finite
     */
    public HeightMap {
        row = List.copyOf(row);
        if (!(spacing > 0) || Double.isInfinite(spacing)) {
            throw new IllegalArgumentException(
                    "a height map's spacing must be above 0 m and finite, but is "
                            + spacing
                            + " m");
        }
        int expected = row.isEmpty() ? 0 : row.getFirst().heights.size();
        for (int j = 0; j < row.size(); j++) {
            check(row.get(j).heights, j + 1, expected);
        }
        if (row.size() < 2 || expected < 2) {
            throw new IllegalArgumentException(
                    "a height map needs at least 2 rows of 2 heights, but has %d of %d"
                            .formatted(row.size(), expected));
        }
    }

    private static void check(Numbers heights, int number, int expected) {
        if (heights.size() != expected) {
            throw new IllegalArgumentException(
                    "row %d of a height map has %d heights, but row 1 has %d; give every row the same number"
                            .formatted(number, heights.size(), expected));
        }
        for (int i = 0; i < expected; i++) {
            if (!Double.isFinite(heights.get(i))) {
                throw new IllegalArgumentException(
                        "height %d of row %d of a height map must be finite, but is %s m"
                                .formatted(i + 1, number, heights.get(i)));
            }
        }
    }

    /** How many heights a row has. */
    int columns() {
        return row.getFirst().heights.size();
    }

    /** The height at a place of the grid; beyond the edge that at the edge (m). */
    double sample(int i, int j) {
        Numbers heights = row.get(Math.clamp(j, 0, row.size() - 1)).heights;
        return heights.get(Math.clamp(i, 0, heights.size() - 1));
    }

    /** Height of the surface at a place (m). */
    double height(double x, double y) {
        double u = Math.clamp(x / spacing, 0, columns() - 1);
        double v = Math.clamp(y / spacing, 0, row.size() - 1);
        int i = Math.min((int) u, columns() - 2);
        int j = Math.min((int) v, row.size() - 2);
        double a = u - i;
        double b = v - j;
        double near = sample(i, j);
        double far = sample(i + 1, j + 1);
        double beside = a >= b ? sample(i + 1, j) : sample(i, j + 1);
        return a >= b
                ? near + a * (beside - near) + b * (far - beside)
                : near + b * (beside - near) + a * (far - beside);
    }

    /** The greatest height (m). */
    double top() {
        double top = Double.NEGATIVE_INFINITY;
        for (int j = 0; j < row.size(); j++) {
            top = Math.max(top, row.get(j).heights().greatest());
        }
        return top;
    }

    @Override
    public double boundingRadius() {
        return Double.POSITIVE_INFINITY;
    }

    @Override
    public Mat3 inertia(double mass) {
        throw new IllegalArgumentException(
                "a height map has no mass: make the object fixed and leave its mass out");
    }

    @Override
    public boolean contains(Vec3 point) {
        return point.z() <= height(point.x(), point.y());
    }

    @Override
    public double reach(Pose pose, double nx, double ny, double nz) {
        return HalfSpace.reachBelow(top(), pose, nx, ny, nz);
    }

    @Override
    public double distance(Ray ray) {
        return new SurfaceRay(ray, this).distance();
    }
}
