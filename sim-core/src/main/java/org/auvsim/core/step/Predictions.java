package org.auvsim.core.step;

import java.util.function.IntConsumer;
import java.util.stream.IntStream;

/**
 * What is going to happen in a frame, as far as the present segments tell: contacts of bodies with
 * each other and with what is no body, and ends of segments that are shorter than the frame. A
 * prediction is void once one of its bodies has begun a new segment. Bodies go by their slots,
 * instants are offsets (s) from the frame's beginning.
 */
final class Predictions {
    /** After two regions have met, events come in the order of time for so many frames. */
    private static final int FRAMES_IN_ORDER = 50;

    private final Motion motion;
    private final BodyTraits traits;
    private final Trajectories trajectories;
    private final int[] version;
    private final Islands islands;
    private final ColumnGrid grid;
    private final Regions regions;
    private final boolean mayHaveRegions;
    private final ContactQueue queue = new ContactQueue();

    private final Lanes lanes;
    private final Encounters[] encounters;
    private final IntConsumer sweepLane = this::sweepLane;
    private final Encounters large;

    /** The one that goes on within the frame, when no lanes run. */
    private final Encounters one;

    private final int[] slotOfRank;

    /** The ranks of what is no body. */
    private final int[] entities;

    private final Neighbours near;

    /** In which batch of movers each body was last predicted. */
    private final int[] batch;

    private int batches;

    /** For so many frames events come in the order of time alone. */
    private int framesInOrder;

    private boolean haveMet;
    private boolean isBeginning;
    private double begin;
    private double length;

    private double time;
    private int first;
    private int second;

    Predictions(
            Motion motion,
            BodyTraits traits,
            Trajectories trajectories,
            ColumnGrid grid,
            Islands islands,
            int[] slotOfRank) {
        this.motion = motion;
        this.traits = traits;
        this.trajectories = trajectories;
        this.grid = grid;
        this.islands = islands;
        this.slotOfRank = slotOfRank;
        version = trajectories.versions();
        lanes = motion.lanes();
        encounters = new Encounters[lanes.count()];
        for (int lane = 0; lane < encounters.length; lane++) {
            encounters[lane] = new Encounters(traits, trajectories, motion.queries());
        }
        one = encounters[0];
        large = new Encounters(traits, trajectories, motion.queries());
        entities = IntStream.range(0, slotOfRank.length).filter(r -> slotOfRank[r] < 0).toArray();
        regions = new Regions(trajectories.paths().boxes(), trajectories.count());
        mayHaveRegions =
                entities.length == 0 && trajectories.groups().isEmpty() && traits.allBounce();
        near = new Neighbours(grid);
        batch = new int[version.length];
    }

    /**
     * Predicts all contacts of bodies in a frame that begins at the world's time {@code begin} (s).
     * Until {@link #complete} what rests on each other is held and not predicted.
     */
    void begin(double begin, double length) {
        this.begin = begin;
        this.length = length;
        isBeginning = true;
        queue.clear();
        findRegions();
        grid.build();
        lanes.run(sweepLane);
        large.clear();
        grid.sweepLarge(large);
        for (Encounters found : encounters) {
            addAll(found);
        }
        addAll(large);
        for (int body = 0; trajectories.hasCuts() && body < version.length; body++) {
            addEnd(body);
        }
    }

    /**
     * Regions are looked for unless some that were found have met of late, which costs a frame that
     * is taken in vain, or something reaches across: what couples bodies, what is no body, or a
     * response of a user's own, which wants the whole world at an instant.
     */
    private void findRegions() {
        haveMet = false;
        regions.clear();
        if (framesInOrder > 0) {
            framesInOrder--;
        } else if (mayHaveRegions) {
            regions.find();
        }
    }

    /** Whether regions were told apart in this frame that have to do with each other after all. */
    boolean haveRegionsMet() {
        return haveMet;
    }

    /** From the next frame on events come in the order of time, for a while. */
    void tellNoRegionsApart() {
        framesInOrder = FRAMES_IN_ORDER;
    }

    /** Whether events come region by region, and so not in the order of time. */
    boolean areByRegion() {
        return regions.areUsed();
    }

    private void sweepLane(int lane) {
        Encounters found = encounters[lane];
        found.clear();
        int columns = grid.columns();
        int from = (int) ((long) columns * lane / encounters.length);
        int to = (int) ((long) columns * (lane + 1) / encounters.length);
        grid.sweep(from, to, found);
    }

    private void addAll(Encounters found) {
        for (int k = 0; k < found.count(); k++) {
            int a = found.firstOf(k);
            int b = found.secondOf(k);
            if (!islands.holdIfResting(a, b)) {
                double known = found.time(k);
                double t = known == Encounters.UNKNOWN ? one.first(a, b) : known;
                if (t < length) {
                    addContact(t, a, b);
                }
            }
        }
    }

    /** All that rests at the frame's beginning is held: adds the meetings with what is no body. */
    void complete() {
        isBeginning = false;
        for (int body = 0; entities.length > 0 && body < version.length; body++) {
            predictEntities(body);
        }
    }

    /** Predicts anew what bodies meet that have begun new segments. */
    void renew(Movers movers) {
        batches++;
        int[] slots = movers.slots();
        for (int k = 0; k < movers.count(); k++) {
            grid.changed(slots[k]);
            haveMet |= !regions.staysInside(slots[k]);
        }
        for (int k = 0; k < movers.count(); k++) {
            predictNeighbours(slots[k]);
            predictEntities(slots[k]);
            addEnd(slots[k]);
            batch[slots[k]] = batches;
        }
    }

    /** A pair of two movers is met twice, and predicted the first time. */
    private void predictNeighbours(int body) {
        near.find(body);
        for (int k = 0; k < near.count(); k++) {
            int a = near.lower(k);
            int b = near.higher(k);
            if (batch[a] != batches && batch[b] != batches) {
                predict(a, b);
            }
        }
    }

    private void predict(int a, int b) {
        if (traits.mayCollide(a, b) && !islands.isHeld(a, b)) {
            double t = one.first(a, b);
            if (t < length && !(isBeginning && islands.holdIfResting(a, b))) {
                addContact(t, a, b);
            }
        }
    }

    private void predictEntities(int body) {
        int rank = traits.rank[body];
        for (int entity : entities) {
            if (motion.mayCollide(rank, entity)) {
                double t = one.first(body, motion.collidable(entity), begin);
                if (t < length) {
                    queue.add(regions.of(body), t, rank, entity, version[body], 0);
                }
            }
        }
    }

    private void addContact(double t, int a, int b) {
        boolean inOrder = traits.rank[a] < traits.rank[b];
        int first = inOrder ? a : b;
        int second = inOrder ? b : a;
        queue.add(
                regions.of(traits.isFixed[first] ? second : first),
                t,
                traits.rank[first],
                traits.rank[second],
                version[first],
                version[second]);
    }

    /** A segment that is shorter than the frame has to be followed by another. */
    private void addEnd(int body) {
        double t = trajectories.paths().endOf(body);
        if (t < length) {
            queue.add(regions.of(body), t, traits.rank[body], ContactQueue.NONE, version[body], 0);
        }
    }

    /** Whether anything is predicted before the frame's end. */
    boolean hasNext() {
        return !queue.isEmpty() && queue.time() < length;
    }

    /** Whether anything is predicted up to an offset. */
    boolean hasNextUntil(double t) {
        return !queue.isEmpty() && queue.time() <= t;
    }

    /** Takes the earliest prediction; whether it is not void. */
    boolean take() {
        time = queue.time();
        first = queue.first();
        second = queue.second();
        int a = slotOfRank[first];
        int b = second < 0 ? -1 : slotOfRank[second];
        boolean isValid =
                version[a] == queue.firstVersion()
                        && (b < 0 || version[b] == queue.secondVersion());
        queue.removeFirst();
        return isValid;
    }

    /** The offset (s) of what has been taken. */
    double time() {
        return time;
    }

    /** Whether it is the end of a segment, and no contact. */
    boolean isEnd() {
        return second == ContactQueue.NONE;
    }

    /** The place of its first one, a body, among all collidables. */
    int first() {
        return first;
    }

    /** The place of the second one of a contact, which need not be a body. */
    int second() {
        return second;
    }
}
