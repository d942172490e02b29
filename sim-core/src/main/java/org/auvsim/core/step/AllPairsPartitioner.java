package org.auvsim.core.step;

/** Puts everything into one set; for a few objects nothing is quicker (thesis, section 5.1.4). */
public record AllPairsPartitioner() implements CollisionPartitioner {
    @Override
    public void partition(Motion motion, double dt, CollisionSets sets) {
        int[] all = sets.scratch(motion.size());
        for (int i = 0; i < motion.size(); i++) {
            all[i] = i;
        }
        sets.add(all, 0, motion.size());
    }
}
