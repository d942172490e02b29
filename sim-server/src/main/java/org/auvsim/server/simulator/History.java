package org.auvsim.server.simulator;

import org.auvsim.server.feedback.PastStep;
import org.auvsim.server.feedback.PendingFeedback;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/** The steps of the recent past, with all that is needed to make them again. */
final class History {
    /** One step, and what clients did after it. */
    static final class Moment {
        /** As things were when the step began. */
        SimulationState before;

        final PastStep step;

        /** The feedback that was used in the step. */
        final List<PendingFeedback> feedback = new ArrayList<>();

        /** What was done between this step and the next one. */
        final List<Deed> after = new ArrayList<>();

        private Moment(SimulationState before, PastStep step) {
            this.before = before;
            this.step = step;
        }
    }

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
        return moments.isEmpty() ? Double.POSITIVE_INFINITY : moments.getFirst().step.start();
    }

    /** A step was made. */
    void add(SimulationState before, PastStep step, List<PendingFeedback> feedback) {
        Moment moment = new Moment(before, step);
        moment.feedback.addAll(feedback);
        moments.add(moment);
        while (moments.getFirst().step.end() < step.end() - horizon) {
            moments.removeFirst();
        }
    }

    /** Something was done after the last step. */
    void add(Deed deed) {
        if (!moments.isEmpty()) {
            moments.getLast().after.add(deed);
        }
    }

    /** The steps from that on in which a time (s) lies. */
    List<Moment> from(double time) {
        return moments.stream().dropWhile(moment -> !moment.step.contains(time)).toList();
    }

    /** Forgets everything: time has jumped. */
    void clear() {
        moments.clear();
    }
}
