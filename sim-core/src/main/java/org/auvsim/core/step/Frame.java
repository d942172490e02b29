package org.auvsim.core.step;

import org.auvsim.core.entity.Contact;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;

/**
 * One frame of the {@link EventStepper}, from the prediction of all contacts to the last event.
 * Scratch of one world, used again for each of its frames. Bodies go by their slots, instants are
 * offsets (s) from the frame's beginning.
 */
final class Frame {
    /** So many events a frame, and so many more a body, mean that a collision never ends. */
    private static final long MOST_EVENTS = 10_000;

    private static final long MOST_EVENTS_A_BODY = 100;

    /** So often at most are islands settled anew at a frame's beginning, as they grow. */
    private static final int MOST_PASSES = 8;

    private final Motion motion;
    private final BodyTraits traits;
    private final Trajectories trajectories;
    private final int[] version;
    private final ColumnGrid grid;
    private final Lanes lanes;
    private final Encounters[] encounters;
    private final ContactQueue queue = new ContactQueue();
    private final int[] slotOfRank;
    private final Encounters large;

    /** The ranks of what is no body. */
    private final int[] entities;

    private final Impacts impacts;
    private final RestingContacts resting;
    private final Settlement settlement;
    private final Crowds crowds;
    private boolean hasHeldMore;
    private final ColumnGrid.Pairs holdAll = this::holdAnyway;
    private final int[] batch;
    private int batches;
    private final int[] pass;
    private int passes;
    private boolean isBeginning;
    private final IntConsumer predictLane = this::predictLane;
    private final ColumnGrid.Pairs predictLate = this::predictOnce;
    private final ColumnGrid.Pairs holdNear = this::holdIfNear;
    private int[] movers = new int[16];
    private int moverCount;
    private final List<Collision> collisions = new ArrayList<>();
    private final List<Pair> touching = new ArrayList<>();
    private final StepTally tally;
    private double interruption;
    private Optional<Contact> before = Optional.empty();
    private StepResult last = StepResult.of(0, List.of());
    private double begin;
    private double length;
    private long events;

    Frame(Motion motion, BodyTraits traits, Trajectories trajectories, int[] slotOfRank) {
        this.motion = motion;
        this.traits = traits;
        this.trajectories = trajectories;
        this.slotOfRank = slotOfRank;
        this.lanes = motion.lanes();
        this.tally = motion.tally();
        version = trajectories.versions();
        grid = new ColumnGrid(trajectories.paths().boxes(), version, trajectories.count(), lanes);
        encounters = new Encounters[lanes.count()];
        for (int lane = 0; lane < encounters.length; lane++) {
            encounters[lane] = new Encounters(traits, trajectories, motion.queries());
        }
        entities = IntStream.range(0, slotOfRank.length).filter(r -> slotOfRank[r] < 0).toArray();
        large = new Encounters(traits, trajectories, motion.queries());
        Touch touch = new Touch(motion.bodies(), traits, motion.queries());
        ContactProblem problem = new ContactProblem(motion.bodies(), traits, trajectories);
        impacts = new Impacts(motion, traits, touch, problem);
        resting = new RestingContacts(traits, trajectories, touch, problem);
        settlement = new Settlement(motion, traits, trajectories, touch, problem, resting);
        crowds = new Crowds(version.length);
        batch = new int[version.length];
        pass = new int[version.length];
    }

    /** Integrates all bodies over the frame and predicts their contacts. */
    void begin(double wanted) {
        begin = motion.time();
        length = wanted;
        events = 0;
        queue.clear();
        collisions.clear();
        touching.clear();
        trajectories.begin(motion.time(), wanted);
        requireMotions();
        grid.build();
        lanes.run(predictLane);
        large.clear();
        grid.sweepLarge(large);
        resting.pairs().clear();
        crowds.clear();
        for (Encounters found : encounters) {
            queueAll(found);
        }
        queueAll(large);
        for (int body = 0; trajectories.hasCuts() && body < version.length; body++) {
            queueEnd(body);
        }
        isBeginning = true;
        settleAll();
        isBeginning = false;
        predictEntities();
    }

    private void requireMotions() {
        motion.requireMild(trajectories.anyTooStiff(), length);
        motion.requireFinite(trajectories.anyNotFinite(), length);
    }

    /** A segment that is shorter than the frame has to be followed by another. */
    private void queueEnd(int body) {
        double t = trajectories.paths().endOf(body);
        if (t < length) {
            queue.add(t, rank(body), ContactQueue.NONE, version[body], 0);
        }
    }

    private void predictLane(int lane) {
        Encounters found = encounters[lane];
        found.clear();
        int columns = grid.columns();
        int from = (int) ((long) columns * lane / encounters.length);
        int to = (int) ((long) columns * (lane + 1) / encounters.length);
        grid.sweep(from, to, found);
    }

    private void queueAll(Encounters found) {
        for (int k = 0; k < found.count(); k++) {
            int a = found.firstOf(k);
            int b = found.secondOf(k);
            if (!hold(a, b) && found.time(k) < length) {
                queueContact(found.time(k), a, b);
            }
        }
    }

    private boolean hold(int a, int b) {
        return answersItself(a, b) && resting.holdIfResting(a, b, length);
    }

    /** Whether the engine answers a collision of the two, and no response of a user's own. */
    private boolean answersItself(int a, int b) {
        return traits.bounces[a] && traits.bounces[b];
    }

    /**
     * Puts the contact forces on all that rests at the frame's beginning. With these forces bodies
     * move differently and may come to rest against more: some passes find most of it.
     */
    private void settleAll() {
        HeldPairs pairs = resting.pairs();
        holdNeighbours();
        int settled = 0;
        for (int round = 0; round < MOST_PASSES && pairs.count() > settled; round++) {
            settled = pairs.count();
            passes++;
            moverCount = 0;
            for (int k = 0; k < settled; k++) {
                int body = traits.isFixed[pairs.first(k)] ? pairs.second(k) : pairs.first(k);
                if (pass[body] != passes) {
                    findIsland(body, body);
                    settle(0);
                }
            }
            predictMovers();
        }
    }

    /**
     * Holds what is near to bodies that are held: with contact forces they are likely to meet, and
     * a contact that does not press costs nothing.
     */
    private void holdNeighbours() {
        HeldPairs pairs = resting.pairs();
        passes++;
        for (int k = 0; k < pairs.count(); k++) {
            holdNeighbours(pairs.first(k));
            holdNeighbours(pairs.second(k));
        }
    }

    private void holdNeighbours(int body) {
        if (!traits.isFixed[body] && pass[body] != passes) {
            pass[body] = passes;
            grid.pairsOf(body, holdNear);
        }
    }

    private void holdIfNear(int a, int b) {
        if (traits.mayCollide(a, b) && !resting.pairs().isHeld(a, b)) {
            hold(a, b);
        }
    }

    /** Settles the island that has been found; its bodies are to be predicted again. */
    private void settle(double t) {
        HeldPairs pairs = resting.pairs();
        crowds.settled(pairs.members(), pairs.memberCount());
        settlement.settle(t, length, begin + t);
        requireMotions();
        for (int k = 0; k < pairs.memberCount(); k++) {
            addMover(pairs.members()[k]);
            pass[pairs.members()[k]] = passes;
        }
    }

    /** Finds all that hangs together with two bodies; a crowd holds all that is near it. */
    private void findIsland(int a, int b) {
        HeldPairs pairs = resting.pairs();
        do {
            pairs.findIsland(a, b);
            hasHeldMore = false;
            for (int k = 0; crowds.any() && k < pairs.memberCount(); k++) {
                if (crowds.isCrowded(pairs.members()[k])) {
                    grid.pairsOf(pairs.members()[k], holdAll);
                }
            }
        } while (hasHeldMore);
    }

    private void holdAnyway(int a, int b) {
        if (traits.mayCollide(a, b)
                && answersItself(a, b)
                && !resting.pairs().isHeld(a, b)
                && resting.holdCrowded(a, b)) {
            hasHeldMore = true;
        }
    }

    private void addMover(int body) {
        if (moverCount == movers.length) {
            movers = Arrays.copyOf(movers, 2 * moverCount);
        }
        movers[moverCount++] = body;
    }

    /** The first meetings of all bodies with what is no body. */
    private void predictEntities() {
        for (int body = 0; entities.length > 0 && body < version.length; body++) {
            predictEntities(body);
        }
    }

    private void predictEntities(int body) {
        for (int entity : entities) {
            if (motion.mayCollide(rank(body), entity)) {
                double t = encounters[0].first(body, motion.collidable(entity), begin);
                if (t < length) {
                    queue.add(t, rank(body), entity, version[body], 0);
                }
            }
        }
    }

    private void predict(int a, int b) {
        if (traits.mayCollide(a, b) && !resting.pairs().isHeld(a, b)) {
            double t = encounters[0].first(a, b);
            if (t < length && !(isBeginning && hold(a, b))) {
                queueContact(t, a, b);
            }
        }
    }

    private void queueContact(double t, int a, int b) {
        boolean inOrder = traits.rank[a] < traits.rank[b];
        int first = inOrder ? a : b;
        int second = inOrder ? b : a;
        queue.add(t, traits.rank[first], traits.rank[second], version[first], version[second]);
    }

    boolean hasNextEvent() {
        return touching.isEmpty() && !queue.isEmpty() && queue.time() < length;
    }

    /** Takes the earliest event. */
    void next() {
        double t = queue.time();
        int first = queue.first();
        int second = queue.second();
        boolean valid = isValid();
        queue.removeFirst();
        if (valid && second == ContactQueue.NONE) {
            tally.events++;
            tally.subSteps++;
            goOnAlone(slotOfRank[first], t);
        } else if (valid) {
            countEvent(first, second, t);
            int a = slotOfRank[first];
            int b = slotOfRank[second];
            if (b >= 0 && answersItself(a, b)) {
                collide(a, b, t);
            } else {
                interrupt(first, second, t);
            }
        }
    }

    private boolean isValid() {
        int b = queue.second() < 0 ? -1 : slotOfRank[queue.second()];
        return version[slotOfRank[queue.first()]] == queue.firstVersion()
                && (b < 0 || version[b] == queue.secondVersion());
    }

    private void countEvent(int first, int second, double t) {
        tally.events++;
        if (++events > MOST_EVENTS + MOST_EVENTS_A_BODY * version.length) {
            throw motion.endless(first, second, events, t);
        }
    }

    private void collide(int a, int b, double t) {
        boolean isCrowded = crowds.isCrowded(a) || crowds.isCrowded(b);
        double limit = isCrowded ? Double.POSITIVE_INFINITY : resting.limitAt(a, b, t, length);
        moverCount = 0;
        if (!traits.isFixed[a]) {
            addMover(a);
        }
        if (!traits.isFixed[b]) {
            addMover(b);
        }
        trajectories.moveTo(movers, moverCount, t);
        boolean heard = motion.isHeard();
        if (heard) {
            before = Optional.of(motion.contact(rank(a), rank(b), begin + t));
        }
        Impacts.Outcome outcome = impacts.meet(a, b, begin + t, limit, heard);
        if (outcome == Impacts.Outcome.BOUNCED || outcome == Impacts.Outcome.STAY) {
            tally.crowdedHits += isCrowded ? 1 : 0;
            tally.collisions++;
            if (heard) {
                collisions.add(new Collision(before.orElseThrow(), impacts.impulse()));
            }
        }
        if (outcome == Impacts.Outcome.STAY || outcome == Impacts.Outcome.PRESSED) {
            resting.stay(a, b, limit);
        }
        goOn(a, b, t);
    }

    /**
     * A response of the user's own may change more than the two: the frame ends here for all, and
     * what else happens at this instant happens there.
     */
    private void interrupt(int first, int second, double t) {
        int a = slotOfRank[first];
        int b = slotOfRank[second];
        moveTo(a, t);
        if (b >= 0) {
            moveTo(b, t);
            if (!motion.approaching(first, second, 0)) {
                goOn(a, b, t);
                return;
            }
        }
        interruption = t;
        addTouching(first, second);
        while (!queue.isEmpty() && queue.time() <= t) {
            if (queue.second() != ContactQueue.NONE && isValid()) {
                addTouching(queue.first(), queue.second());
            }
            queue.removeFirst();
        }
    }

    private void addTouching(int i, int j) {
        touching.add(new Pair(Math.min(i, j), Math.max(i, j)));
    }

    private int rank(int body) {
        return traits.rank[body];
    }

    private void moveTo(int body, double t) {
        if (!traits.isFixed[body]) {
            trajectories.moveTo(body, t);
        }
    }

    /** A segment has ended that was short as its body's forces are stiff: the next one begins. */
    private void goOnAlone(int body, double t) {
        moveTo(body, t);
        goOn(body, body, t);
    }

    /** Begins new segments for the two, and what rests on them, and predicts what they meet. */
    private void goOn(int a, int b, double t) {
        HeldPairs pairs = resting.pairs();
        moverCount = 0;
        if (isJoined(a) || isJoined(b)) {
            findIsland(a, b);
            settle(t);
        } else {
            if (!traits.isFixed[a]) {
                addMover(a);
            }
            if (b != a && !traits.isFixed[b]) {
                addMover(b);
            }
            trajectories.restart(movers, moverCount, t);
            requireMotions();
        }
        predictMovers();
    }

    /** Whether a body cannot go on without others. */
    private boolean isJoined(int body) {
        HeldPairs pairs = resting.pairs();
        return trajectories.groups().isCoupled(body) || (!pairs.isEmpty() && pairs.holds(body));
    }

    private void predictMovers() {
        batches++;
        for (int k = 0; k < moverCount; k++) {
            grid.changed(movers[k]);
        }
        for (int k = 0; k < moverCount; k++) {
            grid.pairsOf(movers[k], predictLate);
            predictEntities(movers[k]);
            queueEnd(movers[k]);
            batch[movers[k]] = batches;
        }
    }

    /** A pair of two movers is met twice, and predicted the first time. */
    private void predictOnce(int a, int b) {
        if (batch[a] != batches && batch[b] != batches) {
            predict(a, b);
        }
    }

    /** The end of the frame becomes the present. */
    StepResult end() {
        if (!touching.isEmpty()) {
            return endEarly();
        }
        trajectories.commit();
        tally.heldPairs += resting.pairs().count();
        motion.begin(motion.time() + length);
        if (last.elapsed() != length || !last.collisions().isEmpty() || !collisions.isEmpty()) {
            last = StepResult.of(length, collisions);
        }
        return last;
    }

    private StepResult endEarly() {
        trajectories.commitAt(interruption);
        motion.begin(motion.time() + interruption);
        StepResult last = Responses.to(motion, touching, interruption);
        tally.collisions += last.collisions().size();
        collisions.addAll(last.collisions());
        return new StepResult(interruption, List.copyOf(collisions), last.changes(), true);
    }

    void undo() {
        trajectories.undo();
        motion.begin(begin);
    }
}
