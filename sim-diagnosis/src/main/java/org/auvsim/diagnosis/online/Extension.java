package org.auvsim.diagnosis.online;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.entity.RemoveEntityCommand;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.server.simulator.Messenger;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Gives the running world what is believed of it: all of that, or nothing. Belongs to the learner's
 * thread.
 */
final class Extension {
    private final Messenger toSimulator;
    private Belief belief;

    /** Of a world that has what is believed. */
    Extension(Belief belief, Messenger toSimulator) {
        this.belief = belief;
        this.toSimulator = toSimulator;
    }

    /** What the world has. */
    Belief belief() {
        return belief;
    }

    /** Whether the world has another belief now; if some of it is refused, it has what it had. */
    boolean reaches(Belief next) throws InterruptedException {
        List<Message> changes = belief.changes(next);
        List<Message> made = made(changes);
        if (made.size() == changes.size()) {
            belief = next;
            return true;
        }
        Belief now = belief.partWay(next, made);
        belief = now.again(belief);
        made(now.changes(belief));
        return false;
    }

    /** Those that are carried out, or need not be: what has left needs not be taken away. */
    private List<Message> made(List<Message> changes) throws InterruptedException {
        if (changes.isEmpty()) {
            return changes;
        }
        List<Optional<ErrorResponse>> answers = toSimulator.send(changes);
        List<Message> made = new ArrayList<>();
        for (int i = 0; i < changes.size(); i++) {
            boolean isGone = changes.get(i) instanceof RemoveEntityCommand;
            boolean isMade =
                    answers.get(i)
                            .map(why -> isGone && why.code() == ErrorCode.UNKNOWN_ENTITY)
                            .orElse(true);
            if (isMade) {
                made.add(changes.get(i));
            }
        }
        return made;
    }
}
