package org.auvsim.server.replay;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.ApplyForceCommand;
import org.auvsim.auvsml.message.control.StepCommand;
import org.auvsim.auvsml.message.feedback.DifferentPositionFeedbackMessage;
import org.auvsim.auvsml.message.feedback.FeedbackAppliedNotification;
import org.auvsim.auvsml.message.listening.ListenerRegistrationRequestCommand;
import org.auvsim.auvsml.message.movement.MovementStateChangeMessage;
import org.auvsim.auvsml.message.movement.StateType;
import org.auvsim.auvsml.message.movement.TimestepAdvancedNotification;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Vec3;

import java.util.ArrayDeque;
import java.util.Queue;
import java.util.Random;

/** A client that has a paused simulator make steps, pushes its object about and corrects it. */
final class ScriptedRobot implements AutoCloseable {
    private final AuvsmlClient client;
    private final Random random;
    private final String handler;
    private final Queue<Message> heard = new ArrayDeque<>();
    private Vec3 position = Vec3.ZERO;
    private int applied;

    ScriptedRobot(int port, Random random, String handler) throws ConnectionException {
        this.client = AuvsmlClient.connect("127.0.0.1", port);
        this.random = random;
        this.handler = handler;
        client.send(ListenerRegistrationRequestCommand.ofAll("1"));
    }

    void send(Message... messages) throws ConnectionException {
        client.send(messages);
    }

    /** Number of corrections that the simulator has made. */
    int applied() {
        return applied;
    }

    /** Has steps made; the robot answers each, in its wait if there is one, else after it. */
    void steps(int count, boolean areProjected) throws ConnectionException {
        for (int i = 0; i < count; i++) {
            if (random.nextInt(3) == 0) {
                client.send(
                        new ApplyForceCommand(
                                1, "engine", Frame.BODY, vector(4), new Vec3(0.1, 0, 0)));
            }
            client.send(new StepCommand(1));
            double time = await(areProjected ? StateType.PROJECTED : StateType.ACTUAL);
            client.send(
                    new DifferentPositionFeedbackMessage(
                            1, time, handler, position, position.plus(vector(0.02)), position));
            if (areProjected) {
                await(StateType.ACTUAL);
            }
        }
    }

    private Vec3 vector(double size) {
        return new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
                .times(size);
    }

    /** Listens up to the end of a step, and returns its time (s). */
    private double await(StateType type) throws ConnectionException {
        while (true) {
            while (heard.isEmpty()) {
                heard.addAll(client.next().orElseThrow().messages());
            }
            switch (heard.remove()) {
                case MovementStateChangeMessage moved -> position = moved.position();
                case FeedbackAppliedNotification _ -> applied++;
                case TimestepAdvancedNotification step when step.stateType() == type -> {
                    return step.timestamp();
                }
                default -> {
                    // of no interest
                }
            }
        }
    }

    @Override
    public void close() {
        client.close();
    }
}
