package org.auvsim.core.step;

import org.auvsim.core.entity.Contact;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * One frame of the {@link EventStepper}: it begins with the prediction of all contacts, goes on
 * from event to event, and ends with all bodies at its end. Scratch of one world, used again for
 * each of its frames. Bodies go by their slots, instants are offsets (s) from the frame's
 * beginning.
 */
final class Frame {
    /** So many events a frame, and so many more a body, mean that a collision never ends. */
    private static final long MOST_EVENTS = 10_000;

    private static final long MOST_EVENTS_A_BODY = 100;

    /** So often at most are islands settled anew at a frame's beginning, as they grow. */
    private static final int MOST_PASSES = 8;

    /** As predictions are taken where regions are not told apart. */
    private static final Comparator<Collision> IN_ORDER =
            Comparator.<Collision>comparingDouble(c -> c.contact().time())
                    .thenComparingLong(c -> c.contact().self().id())
                    .thenComparingLong(c -> c.contact().other().id());

    private final Motion motion;
    private final BodyTraits traits;
    private final StepTally tally;
    private final StepTally tallyBefore = new StepTally();
    private final int[] slotOfRank;

    private final Trajectories trajectories;
    private final Islands islands;
    private final Predictions predictions;
    private final Impacts impacts;
    private final Interruption interruption;
    private final Movers movers;

    private final List<Collision> collisions = new ArrayList<>();
    private StepResult last = StepResult.of(0, List.of());
    private double begin;
    private double length;
    private long events;

    Frame(Motion motion, BodyTraits traits, Trajectories trajectories, int[] slotOfRank) {
        this.motion = motion;
        this.traits = traits;
        this.trajectories = trajectories;
        this.slotOfRank = slotOfRank;
        tally = motion.tally();
        Touch touch = new Touch(motion.bodies(), traits, motion.queries());
        ContactProblem problem = new ContactProblem(motion.bodies(), traits, trajectories);
        ColumnGrid grid =
                new ColumnGrid(
                        trajectories.paths().boxes(),
                        trajectories.versions(),
                        trajectories.count(),
                        motion.lanes());
        islands = new Islands(motion, traits, trajectories, grid, touch, problem);
        predictions = new Predictions(motion, traits, trajectories, grid, islands, slotOfRank);
        impacts = new Impacts(motion, traits, touch, problem);
        interruption = new Interruption(motion, trajectories);
        movers = new Movers(traits);
    }

    /** Integrates all bodies over the frame and predicts their contacts. */
    void begin(double wanted) {
        begin = motion.time();
        length = wanted;
        events = 0;
        collisions.clear();
        interruption.clear();
        tallyBefore.set(tally);
        motion.memory().mark();
        trajectories.begin(begin, length);
        trajectories.requireSound(motion);
        islands.begin(begin, length);
        predictions.begin(begin, length);
        settleAll();
        predictions.complete();
        startOverIfRegionsMet();
    }

    /**
     * Where regions that were told apart have met, the order of events may have been wrong: the
     * frame is taken again, all events in the order of time.
     */
    private void startOverIfRegionsMet() {
        if (predictions.haveRegionsMet()) {
            undo();
            motion.memory().rewind();
            tally.set(tallyBefore);
            predictions.tellNoRegionsApart();
            begin(length);
        }
    }

    /**
     * Puts the contact forces on all that rests at the frame's beginning. With these forces bodies
     * move differently and may come to rest against more: some passes find most of it.
     */
    private void settleAll() {
        islands.holdNeighbours();
        for (int round = 0; round < MOST_PASSES && islands.haveGrown(); round++) {
            movers.clear();
            islands.settleAll(movers);
            predictions.renew(movers);
        }
    }

    boolean hasNextEvent() {
        return !interruption.isPending() && predictions.hasNext();
    }

    /** Takes the earliest event. */
    void next() {
        if (!predictions.take()) {
            return;
        }
        tally.events++;
        double t = predictions.time();
        int a = slotOfRank[predictions.first()];
        if (predictions.isEnd()) {
            tally.subSteps++;
            goOnAlone(a, t);
            return;
        }
        countContact(predictions.first(), predictions.second(), t);
        int b = slotOfRank[predictions.second()];
        if (b >= 0 && traits.bounce(a, b)) {
            collide(a, b, t);
        } else {
            interrupt(predictions.first(), predictions.second(), t);
        }
    }

    /** Counts a contact; so many that there is no end are an error. */
    private void countContact(int first, int second, double t) {
        if (++events > MOST_EVENTS + MOST_EVENTS_A_BODY * trajectories.count()) {
            throw motion.endless(first, second, events, t);
        }
    }

    /** A segment has ended that was short as its body's forces are stiff: the next one begins. */
    private void goOnAlone(int body, double t) {
        moveTo(body, t);
        goOn(body, body, t);
    }

    /** Lets two bodies meet that the engine answers for, alone or with all that rests on them. */
    private void collide(int a, int b, double t) {
        double limit = islands.limitAt(a, b, t);
        movers.set(a, b);
        trajectories.moveTo(movers.slots(), movers.count(), t);
        boolean isHeard = motion.isHeard();
        Optional<Contact> before =
                isHeard
                        ? Optional.of(motion.contact(traits.rank[a], traits.rank[b], begin + t))
                        : Optional.empty();
        Impacts.Outcome outcome = impacts.meet(a, b, begin + t, limit, isHeard);
        if (outcome == Impacts.Outcome.BOUNCED || outcome == Impacts.Outcome.STAY) {
            tally.collisions++;
            tally.crowdedHits += limit == Double.POSITIVE_INFINITY ? 1 : 0;
            if (isHeard) {
                collisions.add(new Collision(before.orElseThrow(), impacts.impulse()));
            }
        }
        if (outcome == Impacts.Outcome.STAY || outcome == Impacts.Outcome.PRESSED) {
            islands.hold(a, b, limit);
        }
        goOn(a, b, t);
    }

    /** Lets two meet that a response of the user's own answers: the frame ends here for all. */
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
        interruption.request(first, second, t, predictions);
    }

    private void moveTo(int body, double t) {
        if (!traits.isFixed[body]) {
            trajectories.moveTo(body, t);
        }
    }

    /** Begins new segments for the two, and what rests on them, and predicts what they meet. */
    private void goOn(int a, int b, double t) {
        if (islands.isJoined(a) || islands.isJoined(b)) {
            movers.clear();
            islands.settle(a, b, t, movers);
        } else {
            movers.set(a, b);
            trajectories.restart(movers.slots(), movers.count(), t);
            trajectories.requireSound(motion);
        }
        predictions.renew(movers);
        startOverIfRegionsMet();
    }

    /** The end of the frame becomes the present. */
    StepResult end() {
        if (interruption.isPending()) {
            return interruption.end(collisions);
        }
        trajectories.commit();
        tally.heldPairs += islands.pairCount();
        motion.begin(motion.time() + length);
        if (predictions.areByRegion()) {
            collisions.sort(IN_ORDER);
        }
        if (last.elapsed() != length || !last.collisions().isEmpty() || !collisions.isEmpty()) {
            last = StepResult.of(length, collisions);
        }
        return last;
    }

    /** Gives all bodies the state back that they had when the frame began. */
    void undo() {
        trajectories.undo();
        motion.begin(begin);
    }
}
