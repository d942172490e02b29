package org.auvsim.cli.feed;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.client.Received;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.feedback.DifferentPositionFeedbackMessage;
import org.auvsim.auvsml.message.feedback.FeedbackAppliedNotification;
import org.auvsim.auvsml.message.movement.MovementStateChangeMessage;
import org.auvsim.auvsml.message.movement.StateType;
import org.auvsim.auvsml.message.movement.TimestepAdvancedNotification;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.auvsml.message.session.LaggingNotification;
import org.auvsim.core.math.Vec3;

import java.util.List;
import java.util.Optional;

/**
 * Plays a log as the robot's side of corrective feedback: each projected movement is answered with
 * the position that was measured at its time, if a sample has come since the last answer. Where the
 * simulator announces no projected movements, actual ones are answered.
 */
public final class LogPlayer {
    private static final String REQUEST_ID = "feedback";

    /** Who has not moved after so many steps never does: it is fixed. */
    private static final int STEPS_WITHOUT_MOVEMENT = 20;

    private final AuvsmlClient client;
    private final long objectId;
    private final String handlerName;
    private final Optional<MeasuredLog> told;
    private final int heldBack;
    private final double end;
    private final Comparison comparison;
    private boolean announced;
    private Optional<MovementStateChangeMessage> arrival = Optional.empty();
    private Optional<MovementStateChangeMessage> departure = Optional.empty();
    private int stepsSeen;
    private int rowsUsed;
    private int sent;
    private int applied;
    private int refused;
    private Optional<String> refusal = Optional.empty();
    private long skipped;
    private double time;

    /**
     * A player of every {@code n}-th sample (0: none) for a world object, over a connection that is
     * registered for that object's projected and actual movements, time steps and used feedback.
     *
     * @param start the simulator's time (s); samples before it are passed over
     */
    public LogPlayer(
            AuvsmlClient client,
            long objectId,
            String handlerName,
            MeasuredLog log,
            int n,
            double start) {
        this.client = client;
        this.objectId = objectId;
        this.handlerName = handlerName;
        List<MeasuredLog.Row> toTell = log.everyNth(n);
        List<MeasuredLog.Row> toCompare = log.allButEveryNth(n);
        told = toTell.isEmpty() ? Optional.empty() : Optional.of(new MeasuredLog(toTell));
        heldBack = toCompare.size();
        end = log.end();
        comparison = new Comparison(toCompare);
        time = start;
        rowsUsed = told.map(rows -> rows.rowsUntil(start)).orElse(0);
    }

    /**
     * Plays until the log or the simulation is over.
     *
     * @throws ConnectionException if the connection breaks
     */
    public FeedTally play() throws ConnectionException {
        boolean over = false;
        while (!over) {
            Optional<Received> received = client.next();
            over = received.isEmpty();
            for (Message message : received.map(Received::messages).orElse(List.of())) {
                over |= take(message);
            }
        }
        return tally();
    }

    /** What has become of the samples so far. */
    private FeedTally tally() {
        Optional<FeedTally.PathError> error =
                comparison.compared() == 0
                        ? Optional.empty()
                        : Optional.of(
                                new FeedTally.PathError(
                                        comparison.compared(),
                                        comparison.rms(),
                                        comparison.largest()));
        boolean moved = departure.isPresent() || stepsSeen < STEPS_WITHOUT_MOVEMENT;
        return new FeedTally(
                heldBack, sent, applied, refused, refusal, skipped, moved, time, end, error);
    }

    /** Uses one message; true when the log is over. */
    private boolean take(Message message) throws ConnectionException {
        switch (message) {
            case MovementStateChangeMessage movement when movement.worldObjectId() == objectId ->
                    moved(movement);
            case TimestepAdvancedNotification step when step.stateType() == StateType.ACTUAL -> {
                stepped();
                time = step.timestamp();
                stepsSeen++;
                boolean neverMoves = departure.isEmpty() && stepsSeen >= STEPS_WITHOUT_MOVEMENT;
                return neverMoves || time >= end - MeasuredLog.SAME_TIME;
            }
            case FeedbackAppliedNotification notice when notice.worldObjectId() == objectId ->
                    applied++;
            case ErrorResponse error -> {
                refused++;
                refusal = refusal.or(() -> Optional.of(error.text()));
            }
            case LaggingNotification lagging -> skipped += lagging.skipped();
            default -> {
                // of no interest here
            }
        }
        return false;
    }

    private void moved(MovementStateChangeMessage movement) throws ConnectionException {
        if (movement.isProjectedState()) {
            announced = true;
            answer(movement);
        } else {
            arrival = arrival.or(() -> Optional.of(movement));
            departure = Optional.of(movement);
        }
    }

    /** A step is done: what was said of the object last, holds. */
    private void stepped() throws ConnectionException {
        if (departure.isEmpty()) {
            return;
        }
        MovementStateChangeMessage here = departure.get();
        comparison.stepped(row(arrival.orElse(here)), row(here));
        arrival = Optional.empty();
        if (!announced) {
            answer(here);
        }
    }

    private static MeasuredLog.Row row(MovementStateChangeMessage movement) {
        return new MeasuredLog.Row(movement.timestamp(), movement.position());
    }

    private void answer(MovementStateChangeMessage movement) throws ConnectionException {
        double at = movement.timestamp();
        int rows = told.map(log -> log.rowsUntil(at)).orElse(0);
        if (rows <= rowsUsed) {
            return;
        }
        rowsUsed = rows;
        MeasuredLog log = told.orElseThrow();
        Vec3 measured = log.positionAt(at);
        client.request(
                REQUEST_ID,
                new DifferentPositionFeedbackMessage(
                        objectId,
                        at,
                        handlerName,
                        movement.position(),
                        measured,
                        log.positionAt(time)));
        sent++;
    }
}
