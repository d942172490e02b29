package org.auvsim.server.simulator;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.framing.Incoming;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.Command;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.auvsml.message.lockstep.LateMember;
import org.auvsim.auvsml.message.lockstep.LockstepTimeoutNotification;
import org.auvsim.auvsml.message.session.CommandDoneResponse;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.auvsml.message.session.WelcomeMessage;
import org.auvsim.core.description.ElementName;
import org.auvsim.core.world.WorldException;
import org.auvsim.server.net.ClientSession;
import org.auvsim.server.net.Notifications;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;

/**
 * Takes what clients send, has it carried out when it is its turn, and answers. Belongs to the
 * simulation thread.
 */
final class Requests {
    private static final Logger LOG = LoggerFactory.getLogger(Requests.class);

    /** So many commands may wait for the end of a step. */
    private static final int MOST_WAITING = 4096;

    private final Notifications notifications;
    private final Members members;
    private final Execution execution;
    private final String serverName;

    /** What waits for the end of the step that is under way, in order of its arrival. */
    private final List<Runnable> waiting = new ArrayList<>();

    /** Those who asked to leave, or have gone, until they have got their answers. */
    private final Set<ClientSession> leaving = new HashSet<>();

    private boolean stepIsUnderWay;

    Requests(Notifications notifications, Members members, Execution execution, String serverName) {
        this.notifications = notifications;
        this.members = members;
        this.execution = execution;
        this.serverName = serverName;
    }

    /** Takes an input. */
    void take(Input input) {
        switch (input) {
            case Input.Came came -> begin(came.session());
            case Input.Sent sent -> take(sent.session(), sent.request());
            case Input.Unreadable unreadable -> refuse(unreadable.session(), unreadable.rejected());
            case Input.Went went -> leave(went.session());
            case Input.TimedOut _ -> timedOut();
            case Input.Asked asked -> betweenSteps(asked.question());
        }
        notifications.flush();
    }

    private void betweenSteps(Runnable action) {
        if (stepIsUnderWay) {
            waiting.add(action);
        } else {
            action.run();
        }
    }

    /** From now on, what decides how the world goes on waits. */
    void stepBegins() {
        stepIsUnderWay = true;
    }

    /** What has waited is carried out: answers of members first. */
    void stepEnds(List<Held> answers) {
        stepIsUnderWay = false;
        answers.forEach(this::carryOut);
        List<Runnable> now = List.copyOf(waiting);
        waiting.clear();
        now.forEach(Runnable::run);
        notifications.flush();
    }

    /** Members have not answered in time. */
    private void timedOut() {
        List<ClientSession> missing = members.missing();
        LOG.warn("step {} waits for {} ({})", members.step(), missing, members.whenLate());
        notifications.toAll(
                new LockstepTimeoutNotification(
                        members.step(),
                        members.whenLate(),
                        missing.stream().map(late -> new LateMember(late.name())).toList()));
        switch (members.whenLate()) {
            case WAIT -> {
                // until the next time
            }
            case GO_ON -> members.skipMissing();
            case RELEASE -> missing.forEach(this::release);
        }
    }

    private void release(ClientSession late) {
        members.leave(late);
        betweenSteps(() -> execution.release(late));
    }

    private void begin(ClientSession session) {
        log(session, "come");
        notifications.add(session);
        session.send(
                new WelcomeMessage(
                        WelcomeMessage.PROTOCOL,
                        serverName,
                        session.id(),
                        session.role().roleName()));
    }

    /** Those of a replayed run do not come and go today. */
    private static void log(ClientSession session, String has) {
        if (!session.isOfThePast()) {
            LOG.info("{} has {}", session, has);
        }
    }

    /** A client goes, after what it has sent is carried out; what it controls is free again. */
    private void leave(ClientSession session) {
        if (notifications.sessions().contains(session) && leaving.add(session)) {
            members.leave(session);
            betweenSteps(() -> end(session));
        }
    }

    /** Ends the session of a client, which is told the reason. */
    void disconnect(ClientSession session, String reason) {
        session.close(reason);
        leave(session);
    }

    private void end(ClientSession session) {
        log(session, "gone");
        leaving.remove(session);
        execution.release(session);
        session.close();
        notifications.remove(session);
    }

    /** Takes the messages of one root element; those that run now are answered in one. */
    private void take(ClientSession session, Incoming.Request request) {
        List<Message> answers = new ArrayList<>();
        for (Message message : request.messages()) {
            if (isHeard(session)) {
                Held held = new Held(session, request.requestId(), message);
                answer(held, () -> takeOrHold(held)).ifPresent(answers::add);
            }
        }
        send(session, request.requestId(), answers);
        if (execution.endsSession(session)) {
            leave(session);
        }
    }

    private boolean isHeard(ClientSession session) {
        return notifications.sessions().contains(session) && !leaving.contains(session);
    }

    private void refuse(ClientSession session, Incoming.Rejected rejected) {
        if (isHeard(session)) {
            session.send(rejected.requestId(), List.of(ErrorResponse.of(rejected.fault())));
        }
    }

    /** What has to wait is kept; what has not is carried out. */
    private Outcome takeOrHold(Held held) {
        execution.requireAllowed(held);
        Optional<Member> member = members.of(held.session());
        if (member.isPresent() && decidesCourse(held.message())) {
            execution.hold(member.get(), held);
            return new Outcome.Waits();
        }
        if (stepIsUnderWay && actsBetweenSteps(held.message())) {
            requireRoom();
            waiting.add(() -> carryOut(held));
            return new Outcome.Waits();
        }
        return new Outcome.Done(execution.execute(held));
    }

    private void requireRoom() {
        if (waiting.size() >= MOST_WAITING) {
            throw new RefusedException(
                    ErrorCode.REFUSED,
                    "more than %d commands wait for the end of this step; send it again later"
                            .formatted(MOST_WAITING));
        }
    }

    private static boolean decidesCourse(Message message) {
        return message instanceof FeedbackMessage || actsBetweenSteps(message);
    }

    private static boolean actsBetweenSteps(Message message) {
        return message instanceof Command<?> command && command.actsBetweenSteps();
    }

    /** Carries out a message whose turn it is, and answers it. */
    void carryOut(Held held) {
        answer(held, () -> new Outcome.Done(execution.execute(held)))
                .ifPresent(answer -> send(held.session(), held.requestId(), List.of(answer)));
    }

    /**
     * Does again what was done before the past was corrected.
     *
     * @return if it is refused now: what tells that to who did it
     */
    Optional<Runnable> repeat(Deed deed) {
        try {
            deed.action().run();
            return Optional.empty();
        } catch (RefusedException | WorldException | IllegalArgumentException e) {
            ErrorResponse told =
                    error(
                            ErrorCode.REFUSED,
                            "%s, carried out before, is refused now that the past is corrected: %s"
                                    .formatted(deed.name(), e.getMessage()));
            return Optional.of(() -> deed.session().send(told));
        }
    }

    private static void send(
            ClientSession session, Optional<String> requestId, List<Message> answers) {
        if (answers.isEmpty() || session.isClosed()) {
            return;
        }
        try {
            session.send(requestId, answers);
        } catch (RuntimeException e) {
            LOG.error("an answer to {} cannot be written", session, e);
            session.send(
                    requestId,
                    List.of(
                            error(
                                    ErrorCode.REFUSED,
                                    "the answer cannot be written in AUVSML; the simulator's log"
                                            + " says why")));
        }
    }

    /** What became of a message. */
    private sealed interface Outcome {
        /** It waits for its turn, and is answered then. */
        record Waits() implements Outcome {}

        /** It is carried out. */
        record Done(Optional<Message> response) implements Outcome {}
    }

    /** An action as it is tried. */
    private interface Attempt {
        Outcome make();
    }

    private Optional<Message> answer(Held held, Attempt attempt) {
        try {
            return switch (attempt.make()) {
                case Outcome.Waits _ -> Optional.empty();
                case Outcome.Done done when done.response().isPresent() -> done.response();
                case Outcome.Done _ -> held.requestId().map(_ -> new CommandDoneResponse());
            };
        } catch (RefusedException e) {
            return Optional.of(ErrorResponse.of(e));
        } catch (WorldException | IllegalArgumentException e) {
            return Optional.of(error(ErrorCode.INVALID_VALUE, String.valueOf(e.getMessage())));
        } catch (RuntimeException e) {
            String name = ElementName.of(held.message().getClass());
            LOG.error("{} of {} failed", name, held.session(), e);
            return Optional.of(
                    error(ErrorCode.REFUSED, name + " failed in the simulator; its log says why"));
        }
    }

    private static ErrorResponse error(ErrorCode code, String text) {
        return new ErrorResponse(code, text, OptionalInt.empty(), OptionalInt.empty());
    }
}
