package org.auvsim.core.volume;

import org.auvsim.core.math.Vec3;

/**
 * The direction in which two boxes overlap least, of the fifteen that can separate them: the
 * normals of their faces and the cross products of their edges (Gottschalk, Lin &amp; Manocha
 * 1996).
 *
 * @param normal unit vector from b toward a
 * @param depth overlap along the normal (m); negative while the boxes are apart
 * @param ofA the axis of a that gives it, 0 to 2; {@link #NONE} for a face of b
 * @param ofB the axis of b that gives it, 0 to 2; {@link #NONE} for a face of a
 */
record LeastPenetration(Vec3 normal, double depth, int ofA, int ofB) {
    static final int NONE = -1;

    /** A later candidate must be better by these shares of the depth and of the boxes' size. */
    private static final double SHARE_OF_DEPTH = 0.02;

    private static final double SHARE_OF_SIZE = 1e-6;

    /** Squared sine of the angle below which edges count as parallel: their faces decide. */
    private static final double PARALLEL = 1e-12;

    /**
     * Searches faces first. A crossing of edges that is better by no more than rounding must not
     * displace a face, or a box at rest would be held now by a face and now by one edge.
     */
    static LeastPenetration of(OrientedBox a, OrientedBox b) {
        LeastPenetration face = ofFaces(a, b);
        double limit = face.depth - margin(face.depth, a, b);
        LeastPenetration best = face;
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                Vec3 axis = a.axis(i).cross(b.axis(j));
                double squared = axis.dot(axis);
                if (squared > PARALLEL) {
                    Vec3 n = axis.times(1 / Math.sqrt(squared));
                    LeastPenetration edges = along(n, a, b, i, j);
                    if (edges.depth < Math.min(limit, best.depth)) {
                        best = edges;
                    }
                }
            }
        }
        return best;
    }

    private static LeastPenetration ofFaces(OrientedBox a, OrientedBox b) {
        LeastPenetration best = along(a.axis(0), a, b, 0, NONE);
        for (int k = 1; k < 6; k++) {
            LeastPenetration face =
                    k < 3
                            ? along(a.axis(k), a, b, k, NONE)
                            : along(b.axis(k - 3), a, b, NONE, k - 3);
            if (face.depth < best.depth - margin(best.depth, a, b)) {
                best = face;
            }
        }
        return best;
    }

    private static LeastPenetration along(
            Vec3 axis, OrientedBox a, OrientedBox b, int ofA, int ofB) {
        double offset = axis.dot(a.centre().minus(b.centre()));
        Vec3 normal = offset < 0 ? axis.negated() : axis;
        double depth = a.reach(axis) + b.reach(axis) - Math.abs(offset);
        return new LeastPenetration(normal, depth, ofA, ofB);
    }

    private static double margin(double depth, OrientedBox a, OrientedBox b) {
        double size = a.half().norm() + b.half().norm();
        return SHARE_OF_DEPTH * Math.abs(depth) + SHARE_OF_SIZE * size;
    }

    /** Whether two edges cross, rather than a face being met. */
    boolean isOfEdges() {
        return ofA != NONE && ofB != NONE;
    }
}
