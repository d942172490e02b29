package org.auvsim.core.step;

import java.util.ArrayList;
import java.util.List;

/**
 * The early end of a frame at a contact that a response of the user's own answers: it may change
 * more than the two, and what else happens at this instant happens there. Collidables go by their
 * ranks.
 */
final class Interruption {
    private final Motion motion;
    private final Trajectories trajectories;
    private final List<Pair> touching = new ArrayList<>();
    private double offset;

    Interruption(Motion motion, Trajectories trajectories) {
        this.motion = motion;
        this.trajectories = trajectories;
    }

    /** A frame begins, and goes to its end so far. */
    void clear() {
        touching.clear();
    }

    boolean isPending() {
        return !touching.isEmpty();
    }

    /** The frame ends at an offset (s) where two touch; takes what else is predicted until then. */
    void request(int i, int j, double offset, Predictions predictions) {
        this.offset = offset;
        add(i, j);
        while (predictions.hasNextUntil(offset)) {
            if (predictions.take() && !predictions.isEnd()) {
                add(predictions.first(), predictions.second());
            }
        }
    }

    private void add(int i, int j) {
        touching.add(new Pair(Math.min(i, j), Math.max(i, j)));
    }

    /** Ends the frame and lets all that touch respond; {@code collisions} happened before. */
    StepResult end(List<Collision> collisions) {
        trajectories.commitAt(offset);
        motion.begin(motion.time() + offset);
        StepResult last = Responses.to(motion, touching, offset);
        motion.tally().collisions += last.collisions().size();
        List<Collision> all = new ArrayList<>(collisions);
        all.addAll(last.collisions());
        return new StepResult(offset, List.copyOf(all), last.changes(), true);
    }
}
