package org.auvsim.experiments.live;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.client.Received;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.EventType;
import org.auvsim.auvsml.message.control.GetSimulatorStateRequest;
import org.auvsim.auvsml.message.control.SimulatorStateResponse;
import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.auvsml.message.listening.ListenerRegistrationRequestCommand;
import org.auvsim.auvsml.message.lockstep.HelloCommand;
import org.auvsim.auvsml.message.lockstep.HelloResponse;
import org.auvsim.auvsml.message.lockstep.ReadyCommand;
import org.auvsim.auvsml.message.movement.MovementStateChangeMessage;
import org.auvsim.auvsml.message.movement.StateType;
import org.auvsim.auvsml.message.movement.TimestepAdvancedNotification;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.core.math.Vec3;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A robot's connection to the simulator. In lock-step it answers projections, which wait for it;
 * else steps that have been made, while the simulator goes on.
 */
final class RobotLink implements AutoCloseable {
    private final AuvsmlClient client;
    private final Participant participant;
    private final boolean isLockstep;
    private Vec3 simulated;
    private long step;

    RobotLink(AuvsmlClient client, Participant participant, boolean isLockstep) {
        this.client = client;
        this.participant = participant;
        this.isLockstep = isLockstep;
        simulated = participant.start();
    }

    /** Joins: when this returns, what the robot sends at first has been taken. */
    void join() throws ConnectionException {
        client.send(registration());
        if (isLockstep) {
            client.send(new HelloCommand("robot " + participant.objectId()));
            step = await(HelloResponse.class).step();
        }
        send(participant.robot().begin());
        client.send(new GetSimulatorStateRequest()); // answered when what was sent before is there
        await(SimulatorStateResponse.class);
    }

    private ListenerRegistrationRequestCommand registration() {
        EventType movement =
                isLockstep ? EventType.PROJECTED_MOVEMENT : EventType.MOVEMENT_STATE_CHANGE;
        return ListenerRegistrationRequestCommand.of(
                Long.toString(participant.objectId()),
                List.of(movement, EventType.TIMESTEP_ADVANCED));
    }

    private <M extends Message> M await(Class<M> type) throws ConnectionException {
        while (true) {
            Received received =
                    client.next()
                            .orElseThrow(
                                    () -> new IllegalStateException("the simulator ended at once"));
            for (Message message : received.messages()) {
                refuseError(message);
                if (type.isInstance(message)) {
                    return type.cast(message);
                }
            }
        }
    }

    private static void refuseError(Message message) {
        if (message instanceof ErrorResponse error) {
            throw new IllegalStateException("the simulator refuses: " + error.text());
        }
    }

    /** Takes part until the simulator ends the connection. */
    void takePart() throws ConnectionException {
        Optional<Received> received = client.next();
        while (received.isPresent()) {
            for (Message message : received.get().messages()) {
                take(message);
            }
            received = client.next();
        }
    }

    private void take(Message message) throws ConnectionException {
        refuseError(message);
        switch (message) {
            case MovementStateChangeMessage moved -> simulated = moved.position();
            case TimestepAdvancedNotification advanced when isToAnswer(advanced) -> {
                answer(participant.robot().answer(advanced.timestamp(), simulated));
                step++;
            }
            default -> {
                // of no interest to a robot
            }
        }
    }

    private boolean isToAnswer(TimestepAdvancedNotification advanced) {
        return advanced.stateType() == (isLockstep ? StateType.PROJECTED : StateType.ACTUAL);
    }

    /** Sends an answer; in lock-step a feedback says that it is complete, or else this does. */
    private void answer(List<Message> answer) throws ConnectionException {
        List<Message> messages = new ArrayList<>(answer);
        if (isLockstep && answer.stream().noneMatch(FeedbackMessage.class::isInstance)) {
            messages.add(new ReadyCommand(step));
        }
        send(messages);
    }

    private void send(List<Message> messages) throws ConnectionException {
        if (!messages.isEmpty()) {
            client.send(messages.toArray(Message[]::new));
        }
    }

    @Override
    public void close() {
        client.close();
    }
}
