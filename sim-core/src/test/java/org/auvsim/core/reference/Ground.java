package org.auvsim.core.reference;

import java.util.List;

/** All points at or below a plane, given by a unit normal and its distance from the origin. */
record Ground(double nx, double ny, double nz, double distance) implements Solid {
    @Override
    public double reach() {
        return 0;
    }

    @Override
    public Ground eroded(double margin) {
        return new Ground(nx, ny, nz, distance - margin);
    }

    @Override
    public void follow(Placement body) {
        // It never moves.
    }

    @Override
    public List<Part> parts() {
        throw new UnsupportedOperationException("the ground meets parts and has none");
    }

    @Override
    public double gapTo(Part part) {
        double least = Double.POSITIVE_INFINITY;
        double[] v = part.vertices;
        for (int i = 0; i < v.length; i += 3) {
            least = Math.min(least, nx * v[i] + ny * v[i + 1] + nz * v[i + 2] - distance);
        }
        return least - part.radius;
    }
}
