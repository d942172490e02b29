package org.auvsim.server;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.message.entity.AddFieldCommand;
import org.auvsim.auvsml.message.entity.RemoveEntityCommand;
import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.server.feedback.AppliedFeedback;
import org.auvsim.server.feedback.Correction;
import org.auvsim.server.feedback.SimpleFixedTimeFeedbackTimestepper;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.AccompaniedProcessor;
import org.auvsim.server.simulator.Companion;
import org.auvsim.server.simulator.Messenger;
import org.auvsim.server.simulator.Simulator;
import org.auvsim.server.simulator.StepMade;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/** What sits beside a simulation changes its world, and is told what is refused. */
@Timeout(60)
class CompanionTest {
    private static final UniformCurrent CURRENT =
            new UniformCurrent(9, "Tide", new Vec3(0.5, 0, 0));

    /** Wants an entity taken away that there is not, and a current, twice. */
    private static final class Meddler implements AccompaniedProcessor {
        private final BlockingQueue<ErrorResponse> refused = new LinkedBlockingQueue<>();
        private final BlockingQueue<List<Optional<ErrorResponse>>> answers =
                new LinkedBlockingQueue<>();

        private void meddle(Messenger toSimulator) {
            try {
                answers.add(
                        toSimulator.send(
                                List.of(
                                        new RemoveEntityCommand(77),
                                        new AddFieldCommand(CURRENT),
                                        new AddFieldCommand(CURRENT))));
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }

        @Override
        public Phase phase() {
            return Phase.BEFORE_STEP;
        }

        @Override
        public void process(Correction correction) {
            // It does not correct.
        }

        @Override
        public Companion companion(World world, long objectId, Messenger toSimulator) {
            Thread.ofVirtual().start(() -> meddle(toSimulator));
            return new Companion() {
                @Override
                public void corrected(FeedbackMessage feedback, AppliedFeedback applied) {
                    // It has begun already.
                }

                @Override
                public void stepMade(StepMade step) {
                    // Likewise.
                }

                @Override
                public void refused(ErrorResponse why) {
                    refused.add(why);
                }

                @Override
                public void close() {
                    // Nothing is open.
                }
            };
        }
    }

    @Test
    void aCompanionChangesTheWorldAndHearsWhatIsRefused() throws Exception {
        World world =
                World.builder()
                        .add(
                                WorldObjectDefinition.named("Drifter")
                                        .volume(new Sphere(0.2))
                                        .mass(1)
                                        .build())
                        .build();
        Meddler meddler = new Meddler();
        TcpTransport tcp = TcpTransport.onLoopback(0);
        try (Simulator simulator =
                        Simulator.of(world)
                                .timestepper(
                                        new SimpleFixedTimeFeedbackTimestepper(
                                                Duration.ofMinutes(2), List.of("client 1")))
                                .processor(meddler)
                                .paused()
                                .transport(tcp)
                                .start();
                RawClient client = RawClient.welcomed(tcp.port())) {
            client.ask(
                    "0",
                    "<listener-registration-request-command register=\"1\"><world-object id=\"1\">"
                            + "<listener type=\"ProjectedMovement\"/></world-object>"
                            + "</listener-registration-request-command>");
            client.send("<auvsml><step-command/></auvsml>");
            client.next("movement-state-change-message");
            client.send(
                    "<auvsml><different-position-feedback-message world-object-id=\"1\""
                            + " timestamp=\"0.05\" handler-name=\"Meddler\">"
                            + "<virtual-position x=\"0\" y=\"0\" z=\"0\"/>"
                            + "<actual-position x=\"1\" y=\"0\" z=\"0\"/>"
                            + "<old-position x=\"0\" y=\"0\" z=\"0\"/>"
                            + "</different-position-feedback-message></auvsml>");

            ErrorResponse refused = meddler.refused.poll(30, TimeUnit.SECONDS);

            assertThat(refused).isNotNull();
            assertThat(refused.text()).contains("77");
            assertThat(meddler.answers.poll(30, TimeUnit.SECONDS))
                    .extracting(Optional::isEmpty)
                    .containsExactly(false, true, false);
            assertThat(simulator.<Object>ask(World::fields)).isEqualTo(List.of(CURRENT));
        }
    }
}
