package org.auvsim.core.reference;

import java.util.List;

/** All points that lie at least {@code depth} (m) below the plane z = 0 of its own axes. */
final class Ground implements Solid {
    private final double depth;

    /** Normal, and distance from the origin (m), where it is now. */
    private final double[] plane = new double[4];

    Ground(double depth) {
        this.depth = depth;
    }

    @Override
    public double swing() {
        return 0;
    }

    @Override
    public Ground eroded(double margin) {
        return new Ground(depth + margin);
    }

    @Override
    public void follow(Placement body) {
        double[] r = body.turn;
        plane[0] = r[2];
        plane[1] = r[5];
        plane[2] = r[8];
        plane[3] = r[2] * body.at[0] + r[5] * body.at[1] + r[8] * body.at[2] - depth;
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
            least =
                    Math.min(
                            least,
                            plane[0] * v[i] + plane[1] * v[i + 1] + plane[2] * v[i + 2] - plane[3]);
        }
        return least - part.radius;
    }
}
