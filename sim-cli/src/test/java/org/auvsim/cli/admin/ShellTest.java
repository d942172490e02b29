package org.auvsim.cli.admin;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.jline.terminal.Terminal;
import org.jline.terminal.impl.DumbTerminal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

import java.io.ByteArrayOutputStream;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;

/** A person at a terminal, whose keys and screen are streams. */
@Timeout(60)
class ShellTest {
    @TempDir private Path folder;

    private final TcpTransport tcp = TcpTransport.onLoopback(0);
    private final MessageCatalogue catalogue =
            MessageCatalogue.load(ShellTest.class.getClassLoader());

    private Simulator simulator() {
        return Simulator.of(
                        World.builder()
                                .add(
                                        WorldObjectDefinition.named("Fish")
                                                .mass(2)
                                                .volume(new Sphere(1))
                                                .build())
                                .build())
                .transport(tcp)
                .paused()
                .start();
    }

    /** What stands on the screen after these keys. */
    private String screenAfter(String keys) throws Exception {
        ByteArrayOutputStream screen = new ByteArrayOutputStream();
        PipedOutputStream keyboard = new PipedOutputStream();
        try (AuvsmlClient client = AuvsmlClient.connect("127.0.0.1", tcp.port(), catalogue);
                Terminal terminal =
                        new DumbTerminal(
                                "test",
                                "dumb",
                                new PipedInputStream(keyboard, 4096),
                                screen,
                                UTF_8)) {
            keyboard.write(keys.getBytes(UTF_8));
            keyboard.flush();
            new Administration(client, catalogue)
                    .converse(terminal, folder.resolve("below").resolve("history"));
        }
        return screen.toString(UTF_8);
    }

    @Test
    void faultsAreToldAndTheNextLineIsRead() throws Exception {
        try (Simulator simulator = simulator()) {
            assertThat(screenAfter("fly\nset rate 3\nremove entity 9\nexit\n"))
                    .contains("There is no command 'fly'; 'help' lists all.")
                    .contains("done")
                    .contains("refused: no entity has the id 9");
            assertThat(simulator.state().rate()).hasValue(3);
        }
    }

    @Test
    void whatWasTypedIsRememberedInTheNextSession() throws Exception {
        try (Simulator simulator = simulator()) {
            screenAfter("set rate 4\nexit\n");
            assertThat(folder.resolve("below").resolve("history")).content().contains("set rate 4");
            assertThat(simulator.state().rate()).hasValue(4);
        }
    }

    @Test
    void theShellEndsWithTheSimulation() throws Exception {
        Simulator simulator = simulator();
        CompletableFuture<String> screen =
                CompletableFuture.supplyAsync(
                        () -> {
                            try {
                                return screenAfter("state\n");
                            } catch (Exception e) {
                                throw new AssertionError(e);
                            }
                        });
        while (simulator.state().clients() == 0) {
            Thread.onSpinWait();
        }
        simulator.close();
        assertThat(screen.join()).contains("* disconnected: the simulation has ended");
    }

    @Test
    void afterTheFarewellNothingIsShown() throws Exception {
        try (Simulator _ = simulator()) {
            assertThat(screenAfter("shutdown\n").strip())
                    .contains("done")
                    .endsWith("* disconnected: the simulation has ended");
        }
    }
}
