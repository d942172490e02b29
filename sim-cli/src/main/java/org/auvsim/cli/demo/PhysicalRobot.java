package org.auvsim.cli.demo;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.client.Received;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.EventType;
import org.auvsim.auvsml.message.feedback.FeedbackAppliedNotification;
import org.auvsim.auvsml.message.learning.ModelCorrectionNotification;
import org.auvsim.auvsml.message.listening.ListenerRegistrationRequestCommand;
import org.auvsim.auvsml.message.movement.MovementStateChangeMessage;
import org.auvsim.auvsml.message.movement.StateType;
import org.auvsim.auvsml.message.movement.TimestepAdvancedNotification;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.core.math.Vec3;

import java.io.EOFException;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleSupplier;

/**
 * The client that is the physical robot: it moves as a {@link TrueRobot} does, its {@link Pilot}
 * commands its simulated self as well and, when it is told where the model will have it, it answers
 * every so many steps where it measures itself to be.
 */
final class PhysicalRobot {
    private final AuvsmlClient link;
    private final Pilot pilot;
    private final TrueRobot body;
    private final Optional<Sensors> sensors;
    private final Track track;
    private final LiveTable table;
    private Vec3 simulated = Vec3.ZERO;
    private Vec3 before = Vec3.ZERO;
    private double correctedAt = Double.NaN;
    private int steps;
    private int refused;
    private Optional<ModelCorrectionNotification> learned = Optional.empty();

    /**
     * A robot at the start.
     *
     * @param sensors what it measures; empty: it sends no feedback
     */
    PhysicalRobot(
            AuvsmlClient link,
            Pilot pilot,
            TrueRobot body,
            Optional<Sensors> sensors,
            Track track,
            LiveTable table) {
        this.link = link;
        this.pilot = pilot;
        this.body = body;
        this.sensors = sensors;
        this.track = track;
        this.table = table;
    }

    /** Asks to be told of everything. */
    void prepare() throws ConnectionException {
        link.send(
                ListenerRegistrationRequestCommand.of(
                        Long.toString(Demonstration.ROBOT_ID),
                        List.of(
                                EventType.MOVEMENT_STATE_CHANGE,
                                EventType.PROJECTED_MOVEMENT,
                                EventType.TIMESTEP_ADVANCED,
                                EventType.FEEDBACK_APPLIED,
                                EventType.MODEL_CORRECTION)));
    }

    /** Moves and answers until a world time (s) that may change as it goes on. */
    void live(DoubleSupplier until) throws IOException {
        double time = 0;
        pilot.stepFrom(time);
        while (time < until.getAsDouble()) {
            Received received = link.next().orElseThrow(PhysicalRobot::gone);
            for (Message message : received.messages()) {
                time = Math.max(time, hear(message));
            }
        }
    }

    private static EOFException gone() {
        return new EOFException("the simulator ended before the flight was over");
    }

    /** What the simulator first said that its model lacks, if it has. */
    Optional<ModelCorrectionNotification> learned() {
        return learned;
    }

    /** Number of corrections that the simulator refused, because they came too late. */
    int refused() {
        return refused;
    }

    /** Deals with a message; the time of the world if it tells that a step is done, else 0. */
    private double hear(Message message) throws ConnectionException {
        switch (message) {
            case MovementStateChangeMessage moved when moved.isProjectedState() -> answer(moved);
            case MovementStateChangeMessage moved -> simulated = moved.position();
            case FeedbackAppliedNotification applied -> correctedAt = applied.timestamp();
            case ModelCorrectionNotification found ->
                    learned = learned.or(() -> Optional.of(found));
            case ErrorResponse _ -> refused++;
            case TimestepAdvancedNotification done when done.stateType() == StateType.ACTUAL -> {
                record(done.timestamp());
                pilot.stepFrom(done.timestamp());
                return done.timestamp();
            }
            default -> {
                // Nothing that a robot needs to know.
            }
        }
        return 0;
    }

    private void answer(MovementStateChangeMessage projected) throws ConnectionException {
        body.moveTo(projected.timestamp());
        steps++;
        if (sensors.isPresent() && sensors.get().areReadAt(steps)) {
            link.send(sensors.get().feedback(projected, body, before));
        }
    }

    private void record(double time) {
        body.moveTo(time);
        before = body.position();
        boolean corrected = correctedAt == time;
        Track.Sample sample = new Track.Sample(time, body.position(), simulated, corrected);
        track.add(sample);
        table.show(track, sample);
    }
}
