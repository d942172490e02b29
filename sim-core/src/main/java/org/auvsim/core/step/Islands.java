package org.auvsim.core.step;

/**
 * What stays in contact for the rest of a frame, island by island: which pairs are held beside
 * those that touch and rest, and how islands are given their contact forces. Bodies go by their
 * slots, instants are offsets (s) from the frame's beginning.
 */
final class Islands {
    private final Motion motion;
    private final BodyTraits traits;
    private final Trajectories trajectories;
    private final RestingContacts resting;
    private final HeldPairs pairs;
    private final Settlement settlement;
    private final Crowds crowds;
    private final Neighbours near;

    /** How many pairs were held when all islands were last settled. */
    private int settled;

    /** In which pass each body was last dealt with. */
    private final int[] pass;

    private int passes;
    private double begin;
    private double length;

    Islands(
            Motion motion,
            BodyTraits traits,
            Trajectories trajectories,
            ColumnGrid grid,
            Touch touch,
            ContactProblem problem) {
        this.motion = motion;
        this.traits = traits;
        this.trajectories = trajectories;
        resting = new RestingContacts(traits, trajectories, touch, problem);
        pairs = resting.pairs();
        settlement = new Settlement(motion, traits, trajectories, touch, problem, resting);
        crowds = new Crowds(trajectories.count());
        near = new Neighbours(grid);
        pass = new int[trajectories.count()];
    }

    /** A frame begins at the world's time {@code begin} (s), in which nothing is held yet. */
    void begin(double begin, double length) {
        this.begin = begin;
        this.length = length;
        settled = 0;
        pairs.clear();
        crowds.clear();
    }

    /** How many pairs are held or have been. */
    int pairCount() {
        return pairs.count();
    }

    boolean isHeld(int a, int b) {
        return pairs.isHeld(a, b);
    }

    /** Holds two from the frame's beginning on if they rest there; whether they do. */
    boolean holdIfResting(int a, int b) {
        return traits.bounce(a, b) && resting.holdIfResting(a, b, length);
    }

    /** Holds two that have met and do not part faster than {@code limit} (m/s). */
    void hold(int a, int b, double limit) {
        resting.stay(a, b, limit);
    }

    /** The speed (m/s) below which two that meet at {@code t} do not part again. */
    double limitAt(int a, int b, double t) {
        return areCrowded(a, b) && resting.restitution(a, b) < 1
                ? Double.POSITIVE_INFINITY
                : resting.limitAt(a, b, t, length);
    }

    /** Whether one of two is where so much collides that all of it cannot be followed. */
    boolean areCrowded(int a, int b) {
        return crowds.isCrowded(a) || crowds.isCrowded(b);
    }

    /** Whether a body cannot go on without others. */
    boolean isJoined(int body) {
        return trajectories.groups().isCoupled(body) || (!pairs.isEmpty() && pairs.holds(body));
    }

    /**
     * Holds what is near to bodies that are held at the frame's beginning: with contact forces they
     * are likely to meet, and a contact that does not press costs nothing.
     */
    void holdNeighbours() {
        passes++;
        for (int k = 0; k < pairs.count(); k++) {
            holdNeighboursOf(pairs.first(k));
            holdNeighboursOf(pairs.second(k));
        }
    }

    private void holdNeighboursOf(int body) {
        if (traits.isFixed[body] || pass[body] == passes) {
            return;
        }
        pass[body] = passes;
        near.find(body);
        for (int k = 0; k < near.count(); k++) {
            int a = near.lower(k);
            int b = near.higher(k);
            if (traits.mayCollide(a, b) && !pairs.isHeld(a, b)) {
                holdIfResting(a, b);
            }
        }
    }

    /** Whether pairs are held that were not when all islands were last settled. */
    boolean haveGrown() {
        return pairs.count() > settled;
    }

    /** Settles all islands at the frame's beginning; their bodies become movers. */
    void settleAll(Movers movers) {
        settled = pairs.count();
        passes++;
        for (int k = 0; k < settled; k++) {
            int body = traits.isFixed[pairs.first(k)] ? pairs.second(k) : pairs.first(k);
            if (pass[body] != passes) {
                settle(body, body, 0, movers);
            }
        }
    }

    /**
     * Begins new segments for all that hangs together with two bodies, which may be one; they
     * become movers.
     */
    void settle(int a, int b, double t, Movers movers) {
        findIsland(a, b);
        crowds.settled(pairs.members(), pairs.memberCount());
        settlement.settle(t, length, begin + t);
        trajectories.requireSound(motion);
        for (int k = 0; k < pairs.memberCount(); k++) {
            movers.add(pairs.members()[k]);
            pass[pairs.members()[k]] = passes;
        }
    }

    /** Finds all that hangs together with two bodies; a crowd holds all that is near it. */
    private void findIsland(int a, int b) {
        do {
            pairs.findIsland(a, b);
        } while (crowds.any() && growByCrowd());
    }

    /** Holds what is near to the crowded bodies of the island; whether that is anything new. */
    private boolean growByCrowd() {
        boolean grows = false;
        for (int k = 0; k < pairs.memberCount(); k++) {
            int body = pairs.members()[k];
            grows |= crowds.isCrowded(body) && holdAllNear(body);
        }
        return grows;
    }

    private boolean holdAllNear(int body) {
        boolean any = false;
        near.find(body);
        for (int k = 0; k < near.count(); k++) {
            int a = near.lower(k);
            int b = near.higher(k);
            any |=
                    traits.mayCollide(a, b)
                            && traits.bounce(a, b)
                            && !pairs.isHeld(a, b)
                            && resting.holdCrowded(a, b);
        }
        return any;
    }
}
