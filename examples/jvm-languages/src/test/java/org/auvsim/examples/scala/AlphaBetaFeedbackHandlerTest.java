package org.auvsim.examples.scala;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.EventType;
import org.auvsim.auvsml.message.control.StepCommand;
import org.auvsim.auvsml.message.feedback.DifferentPositionFeedbackMessage;
import org.auvsim.auvsml.message.listening.ListenerRegistrationRequestCommand;
import org.auvsim.auvsml.message.lockstep.HelloCommand;
import org.auvsim.auvsml.message.movement.StateType;
import org.auvsim.auvsml.message.movement.TimestepAdvancedNotification;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Vec3;
import org.auvsim.server.feedback.FeedbackProcessor;
import org.auvsim.server.feedback.FeedbackProcessorContract;
import org.auvsim.server.feedback.FeedbackProcessors;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.IOException;
import java.util.List;

/** As every processor, and found by its name; half of each residual is left. */
class AlphaBetaFeedbackHandlerTest extends FeedbackProcessorContract {
    private static final int STEPS = 60;
    private static final Vec3 START = new Vec3(0, 5, 0);
    private static final Vec3 DRIFT = new Vec3(0.3, -0.1, 0);

    @Override
    protected FeedbackProcessor processor() {
        return FeedbackProcessors.standard().named("AlphaBetaFeedbackHandler");
    }

    @Override
    protected double accuracy() {
        return 0.5 * new Vec3(0.01, -0.01, 0.02).norm() + 1e-12;
    }

    /** An alpha-beta filter follows whatever goes straight on without an error that stays. */
    @Test
    @Timeout(60)
    void aBoatThatDriftsIsFollowed() throws Exception {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator simulator =
                        Simulator.of(BungeeScenario.scenario()).paused().transport(tcp).start();
                AuvsmlClient robot = AuvsmlClient.connect("127.0.0.1", tcp.port())) {
            robot.send(
                    ListenerRegistrationRequestCommand.of(
                            "2", List.of(EventType.TIMESTEP_ADVANCED)));
            robot.send(new HelloCommand("Boat"), new StepCommand(1));
            for (int step = 1; step <= STEPS; step++) {
                double time = await(robot, StateType.PROJECTED);
                Vec3 measured = START.plus(DRIFT.times(time));
                robot.send(
                        new DifferentPositionFeedbackMessage(
                                2, time, "IgnoreFeedbackHandler", Vec3.ZERO, measured, Vec3.ZERO));
                await(robot, StateType.ACTUAL);
                WorldObject boat = simulator.ask(world -> world.object(2));
                if (step == 1) {
                    Vec3 half = START.plus(measured).times(0.5);
                    assertThat(boat.position().distance(half)).isCloseTo(0, within(1e-12));
                }
                // A step that has begun waits for the boat, and whoever asks for the world with it.
                if (step < STEPS) {
                    robot.send(new StepCommand(1));
                }
            }
            WorldObject boat = simulator.ask(world -> world.object(2));
            assertThat(boat.velocity().distance(DRIFT)).isLessThan(1e-3);
        }
    }

    private static double await(AuvsmlClient robot, StateType state) throws IOException {
        while (true) {
            for (Message message : robot.next().orElseThrow().messages()) {
                if (message instanceof TimestepAdvancedNotification told
                        && told.stateType() == state) {
                    return told.timestamp();
                }
            }
        }
    }
}
