package org.auvsim.core.step;

import org.auvsim.core.contact.RestitutionRule;
import org.auvsim.core.volume.Manifold;

/**
 * Decides which pairs stay in contact for the rest of a frame: those that meet so slowly that they
 * would part and meet again within the frame, and those that are too crowded to part at all. They
 * are kept as {@link HeldPairs}; a {@link Settlement} gives the islands that they form the forces
 * that keep them apart.
 */
final class RestingContacts {
    /** The gap (m) that resting contacts keep open, as a share of the smaller bounding radius. */
    static final double MARGIN = 1e-5;

    /** A pair that stays together may part by this share of the smaller bounding radius. */
    private static final double HOP = 0.02;

    private final BodyTraits traits;
    private final Trajectories trajectories;
    private final Touch touch;
    private final ContactProblem problem;
    private final HeldPairs held;
    private final Manifold manifold = new Manifold();
    private final double[] approaches = new double[2];

    RestingContacts(
            BodyTraits traits, Trajectories trajectories, Touch touch, ContactProblem problem) {
        this.traits = traits;
        this.trajectories = trajectories;
        this.touch = touch;
        this.problem = problem;
        this.held = new HeldPairs(traits, trajectories.groups());
    }

    HeldPairs pairs() {
        return held;
    }

    /**
     * Holds a pair that touches, or will in this frame, if it is to rest: it meets so slowly that
     * it would not part again within the frame.
     *
     * @param length of the frame (s), at whose beginning the pair is
     */
    boolean holdIfResting(int a, int b, double length) {
        if (traits.arePlainBalls(a, b) && isFast(a, b)) {
            return false;
        }
        double reach = hop(a, b) + trajectories.paths().relativeWay(a, b);
        touch.find(a, b, reach, manifold);
        if (manifold.count == 0) {
            return false;
        }
        problem.clear();
        problem.add(a, b, manifold);
        double approach = problem.fastestApproach(0);
        double gap = Math.max(manifold.leastGap(), 0);
        double pressure = pressureAtStart(a, b);
        double limit = limit(a, b, pressure, length);
        double impact = Math.sqrt(approach * approach + 2 * pressure * gap);
        if (restitution(a, b) * impact >= limit || approach < -limit) {
            return false;
        }
        held.hold(a, b, reach, limit);
        return true;
    }

    /** Tells most pairs of balls that bounce without looking at their contact. */
    private boolean isFast(int a, int b) {
        trajectories.paths().approaches(a, b, approaches);
        double pressure = Math.max(0, approaches[1] - approaches[0]);
        return restitution(a, b) * approaches[0] >= limit(a, b, pressure, 1);
    }

    /** Holds a pair that has met and is to stay together, even if it should part a little. */
    void stay(int a, int b, double limit) {
        held.hold(a, b, hop(a, b) + trajectories.paths().relativeWay(a, b), limit);
    }

    /** Holds two that may meet, however fast, if they lose speed in a collision at all. */
    boolean holdCrowded(int a, int b) {
        if (restitution(a, b) == 1) {
            return false;
        }
        stay(a, b, Double.POSITIVE_INFINITY);
        return true;
    }

    private double hop(int a, int b) {
        return HOP * Math.min(traits.radius[a], traits.radius[b]);
    }

    /** How strongly two are pressed together (m/s^2) as the frame begins, where it is strongest. */
    private double pressureAtStart(int a, int b) {
        double most = 0;
        for (int k = 0; k < manifold.count; k++) {
            double pressure =
                    trajectories
                            .paths()
                            .pressure(a, b, 0, manifold.nx[k], manifold.ny[k], manifold.nz[k]);
            most = Math.max(most, pressure);
        }
        return most;
    }

    /**
     * The speed (m/s) below which a pair does not part: that of its {@link RestitutionRule}, and
     * that of a hop which would be over within one frame, as the pair is pressed together. A pair
     * without loss bounces all the same.
     */
    double limit(int a, int b, double pressure, double length) {
        double e = restitution(a, b);
        double rest = RestitutionRule.of(e).restSpeed();
        return e < 1 ? Math.max(rest, pressure * length / 2) : rest;
    }

    /** The same for two that meet at an offset. */
    double limitAt(int a, int b, double offset, double length) {
        if (restitution(a, b) == 1) {
            return limit(a, b, 0, length);
        }
        return limit(a, b, Math.max(0, trajectories.paths().pressure(a, b, offset)), length);
    }

    double restitution(int a, int b) {
        return Math.min(traits.restitution[a], traits.restitution[b]);
    }
}
