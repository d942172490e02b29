package org.auvsim.experiments.hidden;

import org.apache.commons.math3.util.FastMath;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Gives an effect the strength at which it matters as much as wanted: it changes what is measured
 * by a share of its range. That of positions is their largest difference by the path's largest
 * extent, that of attitudes the largest turn by the largest turn of the run; the larger one of both
 * counts, averaged over the runs.
 */
record Strength(Scene scene, Trial trial, List<List<Pose>> believed) {
    private static final int ROUNDS = 8;

    /** Nothing that changes the motion less than this can be meant to be found. */
    private static final double LEAST = 0.03;

    /** What an effect may change at the least strength at which it is what it is. */
    private static final double MOST_AT_LEAST = 3;

    /**
     * The strength that gives the share that is wanted, or as near to it as it may be.
     *
     * @return empty if it hardly does anything, or more than can be followed
     */
    OptionalDouble of(Family family, double wanted) {
        double strength = Math.min(family.unit(), family.most());
        double share = 0;
        for (int round = 0; round < ROUNDS; round++) {
            Optional<Double> measured = share(family.of().apply(strength));
            if (measured.isEmpty()) {
                share = 0;
                if (strength <= family.least()) {
                    break;
                }
                strength = Math.max(family.least(), strength / 8);
                continue;
            }
            share = measured.get();
            double ratio = wanted / share;
            boolean isAtEnd =
                    (ratio > 1 && strength >= family.most())
                            || (ratio < 1 && strength <= family.least());
            if (isAtEnd || (ratio > 0.8 && ratio < 1.25)) {
                break;
            }
            double factor = FastMath.max(0.05, FastMath.min(20, ratio));
            strength = Math.max(family.least(), Math.min(family.most(), strength * factor));
        }
        double most = strength <= family.least() ? MOST_AT_LEAST : 2 * wanted + LEAST;
        return share < LEAST || share > most ? OptionalDouble.empty() : OptionalDouble.of(strength);
    }

    private Optional<Double> share(HiddenEffect effect) {
        return trial.poses(effect.change().apply(Reality.of(scene.plant())))
                .map(
                        changed -> {
                            double sum = 0;
                            for (int r = 0; r < changed.size(); r++) {
                                sum += share(believed.get(r), changed.get(r));
                            }
                            return sum / changed.size();
                        });
    }

    private double share(List<Pose> before, List<Pose> after) {
        double share = 0;
        for (int k = 0; k < before.size(); k++) {
            double away = before.get(k).position().distance(after.get(k).position());
            share = Math.max(share, away / scene.range());
            if (scene.shows()) {
                double turned = before.get(k).attitude().angleTo(after.get(k).attitude());
                share = Math.max(share, turned / scene.turns());
            }
        }
        return share;
    }
}
