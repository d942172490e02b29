package org.auvsim.server;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldCommand;
import org.auvsim.auvsml.message.command.WorldControl;
import org.auvsim.auvsml.message.command.WorldQuery;
import org.auvsim.auvsml.message.command.WorldView;
import org.auvsim.core.world.World;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Input;
import org.auvsim.server.simulator.InputLog;
import org.auvsim.server.simulator.InputPlace;
import org.auvsim.server.simulator.Simulator;
import org.auvsim.server.simulator.StepMade;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.IOException;
import java.util.Optional;

/** Who asks gets an answer, whatever a user's own code does; and the server goes on. */
@Timeout(60)
class UnforeseenFaultTest {
    /** A command that fails. */
    record StumbleCommand() implements WorldCommand {
        @Override
        public Optional<Message> execute(WorldControl world) {
            throw new IllegalStateException("stumbled");
        }
    }

    /** A question whose answer cannot be written: it has a number that is none. */
    record WeighMoonRequest() implements WorldQuery {
        @Override
        public Optional<Message> execute(WorldView world) {
            return Optional.of(new WeighMoonResponse(Double.NaN));
        }
    }

    /** Its answer. */
    record WeighMoonResponse(double mass) implements Message {}

    /** A question that {@link FussyLog} cannot bear. */
    record UnspeakableRequest() implements WorldQuery {
        @Override
        public Role role() {
            return Role.VIEWER;
        }

        @Override
        public Optional<Message> execute(WorldView world) {
            return Optional.empty();
        }
    }

    /** A log that fails. */
    private static final class FussyLog implements InputLog {
        @Override
        public void begun(World world) {
            // bears it
        }

        @Override
        public void taken(InputPlace place, Input input) {
            if (input instanceof Input.Sent(var _, var request)
                    && request.messages().getFirst() instanceof UnspeakableRequest) {
                throw new IllegalStateException("words fail");
            }
        }

        @Override
        public void stepFailed(InputPlace place) {
            // bears it
        }

        @Override
        public void stepMade(StepMade step) {
            // bears it
        }
    }

    private final TcpTransport tcp = TcpTransport.onLoopback(0);
    private final Simulator simulator =
            Simulator.of(Tank.world())
                    .catalogue(catalogue())
                    .log(new FussyLog())
                    .transport(tcp)
                    .paused()
                    .start();
    private RawClient client;

    private static MessageCatalogue catalogue() {
        return MessageCatalogue.of(
                AuvsmlMapper.builder(UnforeseenFaultTest.class.getClassLoader())
                        .register(Message.class, StumbleCommand.class)
                        .register(Message.class, WeighMoonRequest.class)
                        .register(Message.class, WeighMoonResponse.class)
                        .register(Message.class, UnspeakableRequest.class)
                        .build());
    }

    @BeforeEach
    void begin() throws IOException {
        client = RawClient.welcomed(tcp.port());
    }

    @AfterEach
    void end() throws IOException {
        client.close();
        simulator.close();
    }

    private void isAnswered(String message, String text) throws IOException {
        assertThat(client.ask("1", message)).contains("code=\"REFUSED\"").contains(text);
        assertThat(client.ask("2", "<get-simulator-state-request/>"))
                .contains("<simulator-state-response");
    }

    @Test
    void aCommandThatFailsIsAnswered() throws IOException {
        isAnswered(
                "<stumble-command/>", "stumble-command failed in the simulator; its log says why");
    }

    @Test
    void anAnswerThatCannotBeWrittenIsAnsweredOtherwise() throws IOException {
        isAnswered(
                "<weigh-moon-request/>",
                "the answer cannot be written in AUVSML; the simulator's log says why");
    }

    @Test
    void anInputThatALogFailsAtIsAnswered() throws IOException {
        isAnswered("<unspeakable-request/>", "this failed in the simulator; its log says why");
    }
}
