package org.auvsim.server.simulator;

import org.auvsim.server.feedback.PastStep;
import org.auvsim.server.feedback.PendingFeedback;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/** The steps of the recent past, with all that is needed to make them again. */
final class History {
    /**
     * One step, and what clients did after it.
     *
     * @param before as things were when the step began
     * @param feedback what was used in the step
     * @param after what was done between this step and the next one
     */
    record Moment(
            SimulationState before,
            PastStep step,
            List<PendingFeedback> feedback,
            List<Deed> after) {}

    private final Deque<Moment> moments = new ArrayDeque<>();
    private double horizon;

    /** Keeps so much (s) of the past; 0: nothing. */
    History(double horizon) {
        this.horizon = horizon;
    }

    /** Keeps so much (s) of the past from now on. */
    void setHorizon(double horizon) {
        this.horizon = horizon;
    }

    /** Whether anything is kept. */
    boolean isKept() {
        return horizon > 0;
    }

    /** The world's time (s) back to which steps can be made again; infinite: none can. */
    double reachesBackTo() {
        return moments.isEmpty() ? Double.POSITIVE_INFINITY : moments.getFirst().step().start();
    }

    /** A step was made. */
    void add(SimulationState before, PastStep step, List<PendingFeedback> feedback) {
        moments.add(new Moment(before, step, List.copyOf(feedback), new ArrayList<>()));
        while (moments.getFirst().step().end() < step.end() - horizon) {
            moments.removeFirst();
        }
    }

    /** Something was done after the last step. */
    void add(Deed deed) {
        if (!moments.isEmpty()) {
            moments.getLast().after().add(deed);
        }
    }

    /** Whether a time (s) lies in a step that can be made again. */
    boolean reaches(double time) {
        return moments.stream().anyMatch(moment -> moment.step().contains(time));
    }

    /** The steps from that on in which the first of late feedback is true. */
    List<Moment> from(List<PendingFeedback> late) {
        double time = late.getFirst().message().timestamp();
        return moments.stream().dropWhile(moment -> !moment.step().contains(time)).toList();
    }

    /** Puts steps that were made again in the place of as many at the end. */
    void replaceLast(List<Moment> again) {
        again.forEach(_ -> moments.removeLast());
        moments.addAll(again);
    }

    /** Forgets everything: time has jumped. */
    void clear() {
        moments.clear();
    }
}
