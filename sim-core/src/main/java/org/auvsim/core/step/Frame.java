package org.auvsim.core.step;

import static org.auvsim.core.step.Trajectories.CURVE;
import static org.auvsim.core.step.Trajectories.END;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntConsumer;

/**
 * One frame of the {@link EventStepper}, from the prediction of all contacts to the last event.
 * Scratch of one world, used again for each of its frames. Bodies go by their slots, instants are
 * offsets (s) from the frame's beginning.
 */
final class Frame {
    /** So many events a frame, and so many more a body, mean that a collision never ends. */
    private static final long MOST_EVENTS = 10_000;

    private static final long MOST_EVENTS_A_BODY = 100;

    private final Motion motion;
    private final BodyTraits traits;
    private final Trajectories trajectories;
    private final int[] version;
    private final ColumnGrid grid;
    private final Lanes lanes;
    private final Encounters[] encounters;
    private final ContactQueue queue = new ContactQueue();
    private final int[] slotOfRank;
    private final Bounce bounce;
    private final IntConsumer predictLane = this::predictLane;
    private final ColumnGrid.Pairs predictLate = this::predict;
    private final int[] movers = new int[2];
    private final List<Collision> collisions = new ArrayList<>();
    private final List<Pair> touching = new ArrayList<>();
    private final StepTally tally;
    private double interruption;
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
        grid = new ColumnGrid(trajectories.boxes(), version, trajectories.count());
        encounters = new Encounters[lanes.count()];
        for (int lane = 0; lane < encounters.length; lane++) {
            encounters[lane] = new Encounters(traits, trajectories.curves());
        }
        bounce = new Bounce(motion.bodies(), traits);
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
        motion.requireFinite(trajectories.anyNotFinite(), wanted);
        grid.build();
        lanes.run(predictLane);
        grid.sweepLarge(encounters[0]);
        for (Encounters found : encounters) {
            queueAll(found);
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
            queueContact(found.time(k), found.firstOf(k), found.secondOf(k));
        }
        for (int k = 0; k < found.nearCount(); k++) {
            predict(found.firstNear(k), found.secondNear(k));
        }
    }

    private void predict(int a, int b) {
        if (traits.mayCollide(a, b)) {
            double t = encounters[0].first(a, b);
            if (t < length) {
                queueContact(t, a, b);
            }
        }
    }

    private void queueContact(double t, int a, int b) {
        boolean inOrder = traits.rank[a] < traits.rank[b];
        int first = inOrder ? a : b;
        int second = inOrder ? b : a;
        queue.add(
                t, traits.rank[first], traits.rank[second], version[first], version[second]);
    }

    boolean hasNextEvent() {
        return touching.isEmpty() && !queue.isEmpty() && queue.time() < length;
    }

    /** Takes the earliest event. */
    void next() {
        double t = queue.time();
        int a = slotOfRank[queue.first()];
        int b = slotOfRank[queue.second()];
        boolean valid = isValid();
        queue.removeFirst();
        if (valid) {
            countEvent(a, b, t);
            collide(a, b, t);
        }
    }

    private boolean isValid() {
        return version[slotOfRank[queue.first()]] == queue.firstVersion()
                && version[slotOfRank[queue.second()]] == queue.secondVersion();
    }

    private void countEvent(int a, int b, double t) {
        tally.events++;
        if (++events > MOST_EVENTS + MOST_EVENTS_A_BODY * version.length) {
            throw motion.endless(a, b, events, t);
        }
    }

    private void collide(int a, int b, double t) {
        if (!(traits.bounces[a] && traits.bounces[b])) {
            interrupt(a, b, t);
            return;
        }
        moveTo(a, t);
        moveTo(b, t);
        if (bounce.between(a, b)) {
            tally.collisions++;
            if (motion.isHeard()) {
                collisions.add(bounce.collision(motion, t));
            }
        }
        goOn(a, b, t);
    }

    /**
     * A response of the user's own may change more than the two: the frame ends here for all, and
     * what else happens at this instant happens there.
     */
    private void interrupt(int a, int b, double t) {
        moveTo(a, t);
        moveTo(b, t);
        if (!motion.approaching(rank(a), rank(b), 0)) {
            goOn(a, b, t);
            return;
        }
        interruption = t;
        addTouching(rank(a), rank(b));
        while (!queue.isEmpty() && queue.time() <= t) {
            if (isValid()) {
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

    /** Begins new segments for the two and predicts what they meet on them. */
    private void goOn(int a, int b, double t) {
        int count = 0;
        if (!traits.isFixed[a]) {
            movers[count++] = a;
        }
        if (!traits.isFixed[b]) {
            movers[count++] = b;
        }
        trajectories.restart(movers, count, t);
        motion.requireFinite(trajectories.anyNotFinite(), length);
        for (int k = 0; k < count; k++) {
            grid.changed(movers[k]);
        }
        for (int k = 0; k < count; k++) {
            grid.pairsOf(movers[k], predictLate);
        }
    }

    /** The end of the frame becomes the present. */
    StepResult end() {
        if (!touching.isEmpty()) {
            return endEarly();
        }
        trajectories.commit();
        motion.begin(motion.time() + length);
        return StepResult.of(length, collisions);
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
