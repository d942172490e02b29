package org.auvsim.server.simulator;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.server.net.ClientSession;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** A client in lock-step: which steps it has answered, and what it has sent for them. */
final class Member {
    /** So many messages of one member may wait for a step. */
    private static final int MOST_HELD = 4096;

    private final ClientSession session;
    private final long joined;
    private long answered;

    /** What it has sent up to its last answer, and what came after that. */
    private final List<Held> answer = new ArrayList<>();

    private final List<Held> next = new ArrayList<>();
    private final Set<Long> corrected = new HashSet<>();

    /** A member that counts from the step with this number on. */
    Member(ClientSession session, long step) {
        this.session = session;
        joined = step;
        answered = step - 1;
    }

    ClientSession session() {
        return session;
    }

    /** The step that it has to answer next. */
    long owes() {
        return answered + 1;
    }

    /** Whether it counts in a step: who joins when a step is shown already counts after it. */
    boolean countsIn(long step) {
        return joined <= step;
    }

    /**
     * Keeps a message for the step that it is to answer next.
     *
     * @throws RefusedException if too many are kept
     */
    void hold(Held held) {
        if (next.size() >= MOST_HELD) {
            throw new RefusedException(
                    ErrorCode.REFUSED,
                    "more than %d messages of %s wait for step %d; send fewer in a step"
                            .formatted(MOST_HELD, session.name(), owes()));
        }
        next.add(held);
    }

    /**
     * Takes its answer to a step.
     *
     * @param shown the last step that was shown
     * @throws RefusedException if that is not the step that it has to answer
     */
    void ready(long step, long shown) {
        if (step != owes()) {
            throw new RefusedException(
                    ErrorCode.REFUSED,
                    "%s has to answer step %d, not %d".formatted(session.name(), owes(), step));
        }
        if (step > shown) {
            throw new RefusedException(
                    ErrorCode.REFUSED,
                    "step %d has not been shown yet; answer it when it is".formatted(step));
        }
        close();
    }

    /**
     * Feedback for the end of the step that is under way answers it, as soon as there is some for
     * every object that the member controls.
     */
    void corrects(long objectId, Collection<Long> controlled, long underWay) {
        corrected.add(objectId);
        if (owes() == underWay && corrected.containsAll(controlled)) {
            close();
        }
    }

    /** Takes what it has sent as its answer, whether it has said so or not. */
    void skip(long step) {
        answered = Math.max(answered, step);
        corrected.clear();
    }

    private void close() {
        answered++;
        answer.addAll(next);
        next.clear();
        corrected.clear();
    }

    /** What it has sent before the first step in which it counts; it is the caller's now. */
    List<Held> takeOpening(long nextStep) {
        if (joined != nextStep) {
            return List.of();
        }
        List<Held> taken = List.copyOf(next);
        next.clear();
        return taken;
    }

    /** What belongs to the steps that it has answered; it is the caller's now. */
    List<Held> takeAnswer() {
        List<Held> taken = List.copyOf(answer);
        answer.clear();
        return taken;
    }

    /** All that it has sent; it is the caller's now. */
    List<Held> takeAll() {
        List<Held> taken = new ArrayList<>(takeAnswer());
        taken.addAll(next);
        next.clear();
        return taken;
    }
}
