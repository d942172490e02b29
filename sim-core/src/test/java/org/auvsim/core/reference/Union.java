package org.auvsim.core.reference;

import java.util.List;

/** One or several convex parts, fixed to each other. */
record Union(List<Part> parts) implements Solid {
    /** Of a gap that is surely wider (m) a lower bound will do. */
    static final double WIDE = 0.25;

    static Union of(Part... parts) {
        return new Union(List.of(parts));
    }

    @Override
    public double swing() {
        double swing = 0;
        for (Part part : parts) {
            double[] at = part.inBody.at;
            double away = Math.sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
            swing = Math.max(swing, away + part.reach() - part.radius);
        }
        return swing;
    }

    @Override
    public Union eroded(double margin) {
        return new Union(parts.stream().map(part -> part.eroded(margin)).toList());
    }

    @Override
    public void follow(Placement body) {
        parts.forEach(part -> part.follow(body));
    }

    @Override
    public double gapTo(Part other) {
        double least = Double.POSITIVE_INFINITY;
        for (Part part : parts) {
            double rough = part.roughGap(other);
            if (rough < least) {
                least = Math.min(least, rough > WIDE ? rough : gap(part, other));
            }
        }
        return least;
    }

    /**
     * Two cuboids that share no point are nearest at a corner of one of them or at two edges; if
     * they share one, a corner lies inside or an edge pierces.
     */
    private static double gap(Part a, Part b) {
        double least = Math.min(corners(a, b), corners(b, a));
        for (int i = 0; i < a.edges.length; i += 2) {
            for (int j = 0; j < b.edges.length; j += 2) {
                least =
                        Math.min(
                                least,
                                Segments.distance(
                                        a.vertices,
                                        3 * a.edges[i],
                                        3 * a.edges[i + 1],
                                        b.vertices,
                                        3 * b.edges[j],
                                        3 * b.edges[j + 1]));
            }
        }
        return (pierces(a, b) || pierces(b, a) ? 0 : least) - a.radius - b.radius;
    }

    private static double corners(Part a, Part b) {
        double least = Double.POSITIVE_INFINITY;
        double[] v = a.vertices;
        for (int i = 0; i < v.length; i += 3) {
            least = Math.min(least, b.fromCore(v[i], v[i + 1], v[i + 2]));
        }
        return least;
    }

    private static boolean pierces(Part a, Part b) {
        for (int i = 0; i < a.edges.length; i += 2) {
            if (b.cutBy(a.vertices, 3 * a.edges[i], 3 * a.edges[i + 1])) {
                return true;
            }
        }
        return false;
    }
}
