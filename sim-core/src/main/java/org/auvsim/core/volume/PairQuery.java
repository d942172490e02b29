package org.auvsim.core.volume;

/** Answers for one pair of kinds of volume whether and where two of them touch. */
public interface PairQuery<A extends Volume, B extends Volume> {
    /** Whether the two share a point; touching surfaces do. */
    boolean overlap(A a, Pose poseA, B b, Pose poseB);

    /** The contact of two volumes that overlap or nearly touch. */
    ContactPoint contact(A a, Pose poseA, B b, Pose poseB);
}
