package org.auvsim.cli.mirror;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.client.Received;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.feedback.DifferentStateFeedbackMessage;
import org.auvsim.auvsml.message.feedback.FeedbackAppliedNotification;
import org.auvsim.auvsml.message.lockstep.ReadyCommand;
import org.auvsim.auvsml.message.movement.MovementStateChangeMessage;
import org.auvsim.auvsml.message.movement.StateType;
import org.auvsim.auvsml.message.movement.TimestepAdvancedNotification;
import org.auvsim.auvsml.message.session.DisconnectedNotification;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.auvsml.message.session.LaggingNotification;
import org.auvsim.cli.report.UserError;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Vec3;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.TreeMap;

/**
 * Goes along with a server step by step (thesis, section 9.3): brings the mirror's world to the
 * time of each step, compares, and, if it is to correct, answers with the mirror's motion. A server
 * that projects its steps is then compared and answered where it projects, else where it is after
 * each. A time that is told once more, as when late feedback has changed the past, is neither
 * compared nor answered again.
 */
public final class Mirroring {
    /** Less than a simulator takes in one root element, 64 KiB. */
    private static final int MOST_AT_ONCE = 64;

    private static final String CORRECTION = "correction";
    private static final String READY = "ready";

    private final AuvsmlClient client;
    private final MirrorWorld mirror;
    private final Optional<String> processor;
    private final Comparisons listener;
    private final Map<Long, Vec3> served = new TreeMap<>();
    private final Map<Long, Disagreement> disagreements = new TreeMap<>();
    private OptionalLong stepToAnswer;
    private double reached = Double.NEGATIVE_INFINITY;
    private boolean projects;
    private boolean isHeard = true;
    private boolean isOver;
    private int sent;
    private int applied;
    private int refused;
    private Optional<String> refusal = Optional.empty();
    private long skipped;

    /**
     * A mirroring over a connection that is registered for actual and projected movements, time
     * steps and, to correct, used feedback.
     *
     * @param stepToAnswer the first projected step that the server may wait for us in, as its
     *     hello-response says; empty: it does not
     * @param processor the feedback processor to ask for; empty: compares only
     */
    public Mirroring(
            AuvsmlClient client,
            MirrorWorld mirror,
            OptionalLong stepToAnswer,
            Optional<String> processor,
            Comparisons listener) {
        this.client = client;
        this.mirror = mirror;
        this.stepToAnswer = stepToAnswer;
        this.processor = processor;
        this.listener = listener;
    }

    /**
     * Goes along until the simulator says that it ends, be a correction on its way or not, or the
     * client is closed.
     *
     * @throws ConnectionException if what comes is not AUVSML
     * @throws UserError if the connection breaks
     */
    public void run() throws ConnectionException {
        try {
            Optional<Received> received = client.next();
            while (received.isPresent()) {
                take(received.get());
                received = isOver ? Optional.empty() : client.next();
            }
        } catch (ConnectionException e) {
            if (e.getCause() instanceof IOException) {
                throw new UserError(broken(), e);
            }
            throw e;
        }
        if (!isOver && !client.isClosed()) {
            throw new UserError(broken());
        }
    }

    private String broken() {
        return "The connection to %s broke %s: see whether the simulator still runs."
                .formatted(
                        client.address(),
                        Double.isFinite(reached)
                                ? String.format(Locale.ROOT, "at %.6g s", reached)
                                : "before the first step");
    }

    /** What has come of it so far. */
    public MirrorTally tally() {
        List<MirrorTally.Row> rows =
                disagreements.values().stream().map(Disagreement::row).toList();
        return new MirrorTally(rows, sent, applied, refused, refusal, skipped);
    }

    private void take(Received received) {
        for (Message message : received.messages()) {
            take(received.requestId(), message);
        }
    }

    private void take(Optional<String> requestId, Message message) {
        switch (message) {
            case MovementStateChangeMessage moved -> {
                projects |= moved.isProjectedState() && processor.isPresent();
                if (moved.isProjectedState() == projects) {
                    served.put(moved.worldObjectId(), moved.position());
                }
            }
            case TimestepAdvancedNotification step -> {
                boolean isProjected = step.stateType() == StateType.PROJECTED;
                projects |= isProjected && processor.isPresent();
                if (isProjected == projects) {
                    stepped(step.timestamp());
                }
                if (isProjected) {
                    ready();
                }
            }
            case FeedbackAppliedNotification _ -> applied++;
            case ErrorResponse _ when requestId.equals(Optional.of(READY)) -> {
                // it does not wait for us: it is not in lock-step, or the corrections were enough
            }
            case ErrorResponse error -> {
                requireProcessor(error);
                refused++;
                refusal = refusal.or(() -> Optional.of(error.text()));
            }
            case LaggingNotification lagging -> skipped += lagging.skipped();
            case DisconnectedNotification _ -> isOver = true;
            default -> {
                // of no interest here
            }
        }
    }

    /** A processor that the simulator does not have will be refused for ever. */
    private void requireProcessor(ErrorResponse error) {
        boolean isAboutIt =
                error.code() == ErrorCode.UNKNOWN_ENTITY
                        && processor
                                .filter(name -> error.text().contains("'" + name + "'"))
                                .isPresent();
        if (isAboutIt) {
            throw new UserError(error.text());
        }
    }

    private void stepped(double time) {
        if (time - reached <= MirrorWorld.SAME_TIME) {
            return;
        }
        reached = time;
        mirror.advanceTo(time);
        List<Message> corrections = new ArrayList<>();
        for (Map.Entry<Long, Vec3> entry : served.entrySet()) {
            long id = entry.getKey();
            Optional<WorldObject> image = mirror.image(id);
            if (image.isPresent()) {
                compare(time, id, image.get(), entry.getValue());
                processor.ifPresent(
                        name -> corrections.add(correction(time, id, name, image.get())));
            }
        }
        correct(corrections);
    }

    /** Sends them together, since a simulator may go on after the first that it hears of. */
    private void correct(List<Message> corrections) {
        for (int from = 0; from < corrections.size(); from += MOST_AT_ONCE) {
            List<Message> some =
                    corrections.subList(from, Math.min(from + MOST_AT_ONCE, corrections.size()));
            send(CORRECTION, some.toArray(Message[]::new));
            sent += isHeard ? some.size() : 0;
        }
    }

    /** Answers the projected step; each has the next number. */
    private void ready() {
        if (stepToAnswer.isPresent()) {
            long step = stepToAnswer.getAsLong();
            send(READY, new ReadyCommand(step));
            stepToAnswer = OptionalLong.of(step + 1);
        }
    }

    /** Sends, unless the simulator hears no more; what it said last is yet to be read. */
    private void send(String requestId, Message... messages) {
        try {
            if (isHeard) {
                client.request(requestId, messages);
            }
        } catch (ConnectionException _) {
            isHeard = false;
        }
    }

    private void compare(double time, long id, WorldObject image, Vec3 position) {
        listener.compared(time, image.name(), position, image.position());
        disagreements
                .computeIfAbsent(id, _ -> new Disagreement(image.name()))
                .add(position.distance(image.position()));
    }

    private static DifferentStateFeedbackMessage correction(
            double time, long id, String processor, WorldObject image) {
        return new DifferentStateFeedbackMessage(
                id,
                time,
                processor,
                Optional.empty(),
                Optional.of(image.position()),
                Optional.of(image.orientation()),
                Optional.of(image.velocity()),
                Optional.of(image.angularVelocity()),
                Optional.empty());
    }
}
