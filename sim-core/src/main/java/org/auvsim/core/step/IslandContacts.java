package org.auvsim.core.step;

import static org.auvsim.core.contact.ContactBodies.SPEEDS;

import org.auvsim.core.volume.Manifold;
import org.auvsim.core.volume.Pose;

/**
 * The contacts of an island's held pairs, and which belong to which pair. They stand in a {@link
 * ContactProblem}, pair by pair; pairs are numbered as in {@link HeldPairs#pairs}.
 */
final class IslandContacts {
    private final BodyTraits traits;
    private final Paths paths;
    private final Touch touch;
    private final ContactProblem problem;
    private final RestingContacts resting;
    private final HeldPairs held;
    private final Manifold manifold = new Manifold();
    private final BodyCurve curve = new BodyCurve();
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();

    /** The first contact of each pair and, one past the last, their number. */
    private int[] from = new int[64];

    IslandContacts(
            BodyTraits traits,
            Paths paths,
            Touch touch,
            ContactProblem problem,
            RestingContacts resting) {
        this.traits = traits;
        this.paths = paths;
        this.touch = touch;
        this.problem = problem;
        this.resting = resting;
        this.held = resting.pairs();
    }

    /** Finds the contacts of all pairs; those that would bounce, or do not touch, are let go. */
    void findAtStart() {
        if (from.length <= held.pairCount()) {
            from = new int[2 * held.pairCount() + 1];
        }
        for (int k = 0; k < held.pairCount(); k++) {
            from[k] = count();
            touch.find(first(k), second(k), reach(k), manifold);
            problem.add(first(k), second(k), manifold);
            if (manifold.count == 0 || bounces(k)) {
                held.release(held.pairs()[k]);
                problem.contacts.count = from[k];
            }
        }
        from[held.pairCount()] = count();
    }

    /** Whether the last pair would part so fast that it does not stay. */
    private boolean bounces(int k) {
        double e = resting.restitution(first(k), second(k));
        return e * approach(k) >= held.limit(held.pairs()[k]);
    }

    /**
     * How fast (m/s) the last pair approaches where it touches. While one corner stands, another
     * that comes down rests as well: let go, the corner that stands would meet again at once,
     * without end.
     */
    private double approach(int k) {
        double nearness = traits.nearness(first(k), second(k));
        double fastest = Double.NEGATIVE_INFINITY;
        for (int c = from[k]; c < count(); c++) {
            if (problem.gap(c) <= nearness) {
                fastest = Math.max(fastest, -speed(c));
            }
        }
        return fastest > Double.NEGATIVE_INFINITY ? fastest : problem.fastestApproach(from[k]);
    }

    /** Finds the contacts of those still held, where they are halfway through their segments. */
    void findHalfway() {
        for (int k = 0; k < held.pairCount(); k++) {
            from[k] = count();
            if (held.isHeld(held.pairs()[k])) {
                paths.middle(first(k), curve, poseA);
                paths.middle(second(k), curve, poseB);
                double reach = areSpheres(k) ? Double.POSITIVE_INFINITY : 2 * reach(k);
                touch.find(first(k), poseA, second(k), poseB, reach, manifold);
                problem.add(first(k), second(k), manifold);
            }
        }
        from[held.pairCount()] = count();
    }

    /** How many contacts there are. */
    int count() {
        return problem.contacts.count;
    }

    int pairs() {
        return held.pairCount();
    }

    int first(int pair) {
        return held.first(held.pairs()[pair]);
    }

    int second(int pair) {
        return held.second(held.pairs()[pair]);
    }

    /** Gaps up to this (m) count as contacts of a pair. */
    double reach(int pair) {
        return held.reach(held.pairs()[pair]);
    }

    /** The first contact of a pair. */
    int from(int pair) {
        return from[pair];
    }

    /** One past the last contact of a pair. */
    int to(int pair) {
        return from[pair + 1];
    }

    boolean areSpheres(int pair) {
        return traits.isSphere[first(pair)] && traits.isSphere[second(pair)];
    }

    /** The gap (m) that a pair is to keep. */
    double margin(int pair) {
        return traits.nearness(first(pair), second(pair)) / 2;
    }

    /** The least gap (m) that a pair of the island is to keep. */
    double leastMargin() {
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < pairs(); k++) {
            least = Math.min(least, margin(k));
        }
        return least;
    }

    /** The bounding radius (m) of the smaller body of a pair. */
    double smallerRadius(int pair) {
        return Math.min(traits.radius[first(pair)], traits.radius[second(pair)]);
    }

    /** How fast the bodies part at a contact (m/s), as they move in the problem. */
    double speed(int contact) {
        return problem.contacts.separationSpeed(contact, problem.bodies);
    }

    /** The least of some numbers, one a contact, at the contacts of a pair; infinite for none. */
    double least(int pair, double[] numbers) {
        double least = Double.POSITIVE_INFINITY;
        for (int c = from(pair); c < to(pair); c++) {
            least = Math.min(least, numbers[c]);
        }
        return least;
    }

    /**
     * How fast a pair's speeds of approach change as it slides and turns, moving as in the problem
     * (m/s^2): roughly, as if the bodies were as round as their bounding spheres.
     */
    double bend(int pair) {
        int a = first(pair);
        int b = second(pair);
        double[] v = problem.bodies.v;
        int p = SPEEDS * problem.body(a);
        int q = SPEEDS * problem.body(b);
        double x = v[p] - v[q];
        double y = v[p + 1] - v[q + 1];
        double z = v[p + 2] - v[q + 2];
        double slide = (x * x + y * y + z * z) / (traits.radius[a] + traits.radius[b]);
        return traits.arePlainBalls(a, b) ? slide : slide + turn(a, p) + turn(b, q);
    }

    /** The acceleration (m/s^2) of a body's farthest point as it turns. */
    private double turn(int slot, int at) {
        double x = problem.bodies.v[at + 3];
        double y = problem.bodies.v[at + 4];
        double z = problem.bodies.v[at + 5];
        double squared = x * x + y * y + z * z;
        // What is unbounded does not turn.
        return squared > 0 ? squared * traits.radius[slot] : 0;
    }
}
