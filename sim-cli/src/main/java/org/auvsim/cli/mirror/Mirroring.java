package org.auvsim.cli.mirror;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.client.Received;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.feedback.DifferentStateFeedbackMessage;
import org.auvsim.auvsml.message.feedback.FeedbackAppliedNotification;
import org.auvsim.auvsml.message.movement.MovementStateChangeMessage;
import org.auvsim.auvsml.message.movement.StateType;
import org.auvsim.auvsml.message.movement.TimestepAdvancedNotification;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.auvsml.message.session.LaggingNotification;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * Goes along with a server step by step (thesis, section 9.3): brings the mirror's world to the
 * time of each step, compares, and, if it is to correct, answers with the mirror's motion. A server
 * that projects its steps is then compared and answered where it projects, else where it is after
 * each.
 */
public final class Mirroring {
    private static final String REQUEST_ID = "correction";

    private final AuvsmlClient client;
    private final MirrorWorld mirror;
    private final Optional<String> processor;
    private final Comparisons listener;
    private final Map<Long, Vec3> served = new TreeMap<>();
    private final Map<Long, Disagreement> disagreements = new TreeMap<>();
    private boolean projects;
    private boolean isOver;
    private int sent;
    private int applied;
    private int refused;
    private Optional<String> refusal = Optional.empty();
    private long skipped;

    /**
     * A mirroring over a connection that is registered for actual movements, time steps and, to
     * correct, projected movements and used feedback.
     *
     * @param processor the feedback processor to ask for; empty: compares only
     */
    public Mirroring(
            AuvsmlClient client,
            MirrorWorld mirror,
            Optional<String> processor,
            Comparisons listener) {
        this.client = client;
        this.mirror = mirror;
        this.processor = processor;
        this.listener = listener;
    }

    /**
     * Goes along until the simulation has ended, be a correction on its way or not.
     *
     * @throws ConnectionException if the connection breaks
     */
    public void run() throws ConnectionException {
        Optional<Received> received = client.next();
        while (received.isPresent()) {
            for (Message message : received.get().messages()) {
                take(message);
            }
            received = isOver ? Optional.empty() : client.next();
        }
    }

    /** What has come of it so far. */
    public MirrorTally tally() {
        List<MirrorTally.Row> rows =
                disagreements.values().stream().map(Disagreement::row).toList();
        return new MirrorTally(rows, sent, applied, refused, refusal, skipped);
    }

    private void take(Message message) {
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
            }
            case FeedbackAppliedNotification _ -> applied++;
            case ErrorResponse error -> {
                refused++;
                refusal = refusal.or(() -> Optional.of(error.text()));
            }
            case LaggingNotification lagging -> skipped += lagging.skipped();
            default -> {
                // of no interest here
            }
        }
    }

    private void stepped(double time) {
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
        if (!isOver) {
            send(corrections);
        }
    }

    private void send(List<Message> corrections) {
        try {
            for (Message correction : corrections) {
                client.request(REQUEST_ID, correction);
                sent++;
            }
        } catch (ConnectionException _) {
            isOver = true; // the simulator ended before it could hear of them
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
