package org.auvsim.experiments.hidden;

import org.apache.commons.math3.exception.MathIllegalArgumentException;
import org.apache.commons.math3.exception.MathIllegalStateException;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;

/**
 * Runs to be made, and how they go under one reality or another.
 *
 * @param seeds of what differs from run to run
 */
record Trial(List<Manoeuvre> manoeuvres, List<Long> seeds) {
    /** Height (m) below which a body must stay for the water's surface to play no part. */
    private static final double UNDER_WATER = -1;

    /** What sensors without noise tell; empty if it cannot be followed or leaves the water. */
    Optional<List<List<Pose>>> poses(Reality reality) {
        List<List<Pose>> all = new ArrayList<>();
        for (int r = 0; r < manoeuvres.size(); r++) {
            List<Pose> run;
            try {
                run =
                        Simulation.poses(
                                reality, manoeuvres.get(r), new SplittableRandom(seeds.get(r)));
            } catch (MathIllegalStateException | MathIllegalArgumentException e) {
                return Optional.empty();
            }
            if (!isUsable(reality, run)) {
                return Optional.empty();
            }
            all.add(run);
        }
        return Optional.of(all);
    }

    private static boolean isUsable(Reality reality, List<Pose> run) {
        boolean floats = reality.plant().displaced() > 0;
        return run.stream()
                .allMatch(
                        pose ->
                                pose.position().getNorm() < 1e4
                                        && !(floats && pose.position().getZ() > UNDER_WATER));
    }
}
