package org.auvsim.core.volume;

import org.auvsim.core.math.Vec3;

/** Where an edge of one box crosses an edge of another. */
final class CrossingEdges {
    private CrossingEdges() {}

    /**
     * Halfway between the nearest points of two edges that are not parallel (Ericson 2005, section
     * 5.1.9): of a, the one along its axis {@code ofA} that is farthest toward b; of b, the one
     * along its axis {@code ofB} that is farthest the other way.
     */
    static Vec3 middle(OrientedBox a, int ofA, Vec3 towardB, OrientedBox b, int ofB) {
        Vec3 u = a.axis(ofA);
        Vec3 v = b.axis(ofB);
        Vec3 onA = a.edgeMiddle(ofA, towardB);
        Vec3 onB = b.edgeMiddle(ofB, towardB.negated());
        Vec3 between = onA.minus(onB);
        double cosine = u.dot(v);
        double alongU = u.dot(between);
        double alongV = v.dot(between);
        double sineSquared = 1 - cosine * cosine;
        double s = clamp((cosine * alongV - alongU) / sineSquared, a.half(ofA));
        double t = clamp((alongV - cosine * alongU) / sineSquared, b.half(ofB));
        return onA.plus(u.times(s)).plus(onB.plus(v.times(t))).times(0.5);
    }

    private static double clamp(double along, double half) {
        return Math.clamp(along, -half, half);
    }
}
