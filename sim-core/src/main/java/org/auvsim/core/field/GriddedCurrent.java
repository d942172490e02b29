package org.auvsim.core.field;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Domain;
import org.auvsim.core.math.Numbers;
import org.auvsim.core.math.Vec3;

import java.util.Optional;

/**
 * Water whose velocity is given at the points of a grid, as an ocean model writes it, and linear
 * along each axis between them (trilinear). Outside of the grid it is that at its edge. It does not
 * change with time.
 *
 * <p>Velocities stand in order of z, then y, then x: those along the first line of x, then the next
 * y, and so on.
 *
 * @param file a CSV file from which all numbers are read instead; empty where they are stated
 * @param x places of the grid (m, world), ascending; one is enough where nothing changes along x
 * @param y likewise
 * @param z likewise
 * @param u velocity along the world's x (m/s) at each point
 * @param v along y
 * @param w along z
 */
public record GriddedCurrent(
        long id,
        String name,
        Optional<String> file,
        @Unit("m") @Default("0") Numbers x,
        @Unit("m") @Default("0") Numbers y,
        @Unit("m") @Default("0") Numbers z,
        @Unit("m/s") @Default("0") Numbers u,
        @Unit("m/s") @Default("0") Numbers v,
        @Unit("m/s") @Default("0") Numbers w)
        implements Current {
    private static final Numbers NONE = Numbers.of(0);

    /**
     * A checked current.
     *
     * @throws IllegalArgumentException if the places do not ascend, a component of the velocity is
     *     not given at each point, or both a file and numbers are stated
     */
    public GriddedCurrent {
        String current = "current '" + name + "'";
        GridAxis.requireAscending(current, "x", x);
        GridAxis.requireAscending(current, "y", y);
        GridAxis.requireAscending(current, "z", z);
        requireComplete(current, "u", u, x, y, z);
        requireComplete(current, "v", v, x, y, z);
        requireComplete(current, "w", w, x, y, z);
        if (file.isPresent() && !(x.equals(NONE) && y.equals(NONE) && z.equals(NONE))) {
            throw new IllegalArgumentException(
                    "%s must have either a file or numbers, but has both and the file is %s"
                            .formatted(current, file.get()));
        }
    }

    /** The current of these numbers. */
    public GriddedCurrent(
            long id,
            String name,
            Numbers x,
            Numbers y,
            Numbers z,
            Numbers u,
            Numbers v,
            Numbers w) {
        this(id, name, Optional.empty(), x, y, z, u, v, w);
    }

    private static void requireComplete(
            String current, String which, Numbers values, Numbers x, Numbers y, Numbers z) {
        long points = (long) x.size() * y.size() * z.size();
        if (values.size() != points) {
            throw new IllegalArgumentException(
                    ("%s of %s must have a number for each of the %d points (%d x %d x %d), but has"
                                    + " %d")
                            .formatted(
                                    which,
                                    current,
                                    points,
                                    x.size(),
                                    y.size(),
                                    z.size(),
                                    values.size()));
        }
        for (int i = 0; i < values.size(); i++) {
            Domain.finite(current, "number " + (i + 1) + " of " + which, values.get(i), "m/s");
        }
    }

    @Override
    public Current prepared() {
        if (file.isPresent()) {
            throw new IllegalArgumentException(
                    ("current '%s' has not read its file %s: only a scenario that is itself loaded"
                                    + " from a file can name one")
                            .formatted(name, file.get()));
        }
        return this;
    }

    @Override
    public Vec3 valueAt(Vec3 position, double time) {
        int i = GridAxis.index(x, position.x());
        int j = GridAxis.index(y, position.y());
        int k = GridAxis.index(z, position.z());
        int at = point(i, j, k);
        double a = GridAxis.share(x, i, position.x());
        double b = GridAxis.share(y, j, position.y());
        double c = GridAxis.share(z, k, position.z());
        return new Vec3(between(u, at, a, b, c), between(v, at, a, b, c), between(w, at, a, b, c));
    }

    private int point(int i, int j, int k) {
        return (k * y.size() + j) * x.size() + i;
    }

    /** Between the eight points of a cell, at these shares of its edges. */
    private double between(Numbers of, int at, double a, double b, double c) {
        int dz = z.size() > 1 ? x.size() * y.size() : 0;
        return (1 - c) * across(of, at, a, b) + c * across(of, at + dz, a, b);
    }

    private double across(Numbers of, int at, double a, double b) {
        int dx = x.size() > 1 ? 1 : 0;
        int dy = y.size() > 1 ? x.size() : 0;
        double near = (1 - a) * of.get(at) + a * of.get(at + dx);
        double far = (1 - a) * of.get(at + dy) + a * of.get(at + dy + dx);
        return (1 - b) * near + b * far;
    }

    @Override
    public void addTo(Block block) {
        for (int i = 0; i < block.count; i++) {
            add(block, i, block.ux, 3, u);
            add(block, i, block.uy, 6, v);
            add(block, i, block.uz, 9, w);
        }
    }

    /**
     * One component and its change along each axis, which is that from side to side of the cell.
     */
    private void add(Block block, int body, double[] to, int row, Numbers of) {
        double px = block.state[BodyState.X][body];
        double py = block.state[BodyState.Y][body];
        double pz = block.state[BodyState.Z][body];
        int i = GridAxis.index(x, px);
        int j = GridAxis.index(y, py);
        int k = GridAxis.index(z, pz);
        int at = point(i, j, k);
        double a = GridAxis.share(x, i, px);
        double b = GridAxis.share(y, j, py);
        double c = GridAxis.share(z, k, pz);
        to[body] += between(of, at, a, b, c);
        block.flow[row][body] +=
                GridAxis.slope(x, i, px) * (between(of, at, 1, b, c) - between(of, at, 0, b, c));
        block.flow[row + 1][body] +=
                GridAxis.slope(y, j, py) * (between(of, at, a, 1, c) - between(of, at, a, 0, c));
        block.flow[row + 2][body] +=
                GridAxis.slope(z, k, pz) * (between(of, at, a, b, 1) - between(of, at, a, b, 0));
    }
}
