package org.auvsim.core.volume;

/**
 * Two bounded volumes of this package: the least distance of a convex part of one and a convex part
 * of the other.
 */
final class SolidPair<A extends Volume, B extends Volume> implements SolidQuery<A, B> {
    /** The volumes are taken in one order whichever way they come: same result to the bit. */
    @Override
    public double distance(A a, Pose poseA, B b, Pose poseB, Separation to) {
        if (Solids.inOrder(a, poseA, b, poseB)) {
            Solids.distance(a, poseA, b, poseB, to);
        } else {
            Solids.distance(b, poseB, a, poseA, to);
            to.flip();
        }
        return to.distance;
    }

    @Override
    public void manifold(A a, Pose poseA, B b, Pose poseB, double margin, Manifold to) {
        to.clear();
        if (Solids.inOrder(a, poseA, b, poseB)) {
            Solids.manifold(a, poseA, b, poseB, margin, to);
        } else {
            Solids.manifold(b, poseB, a, poseA, margin, to);
            to.flip();
        }
    }
}
