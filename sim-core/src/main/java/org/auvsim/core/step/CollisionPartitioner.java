package org.auvsim.core.step;

/** The second stage: puts collidables that may meet into common sets (thesis, section 5.1.2). */
public interface CollisionPartitioner {
    /**
     * Adds collision sets to {@code sets}, so that each pair whose swept spheres over {@code dt}
     * (s) overlap shares a set (thesis, equation 5.1).
     */
    void partition(Motion motion, double dt, CollisionSets sets);
}
