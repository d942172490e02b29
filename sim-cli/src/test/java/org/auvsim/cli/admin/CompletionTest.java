package org.auvsim.cli.admin;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.jline.reader.Candidate;
import org.jline.reader.LineReader;
import org.jline.reader.LineReaderBuilder;
import org.jline.reader.Parser.ParseContext;
import org.jline.reader.impl.DefaultParser;
import org.jline.terminal.impl.DumbTerminal;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;

/** What Tab offers, with a simulator that tells its objects. */
@Timeout(60)
class CompletionTest {
    private static final Propulsor TAIL =
            new Propulsor("Tail", 10, 0, Vec3.ZERO, new Vec3(1, 0, 0));

    private final TcpTransport tcp = TcpTransport.onLoopback(0);
    private final MessageCatalogue catalogue =
            MessageCatalogue.load(CompletionTest.class.getClassLoader());
    private final Simulator simulator =
            Simulator.of(
                            World.builder()
                                    .add(
                                            WorldObjectDefinition.named("Red Fish")
                                                    .mass(2)
                                                    .volume(new Sphere(1))
                                                    .component(TAIL)
                                                    .build())
                                    .build())
                    .transport(tcp)
                    .paused()
                    .start();
    private AuvsmlClient client;
    private Completion completion;

    @BeforeEach
    void begin() throws IOException {
        client = AuvsmlClient.connect("127.0.0.1", tcp.port(), catalogue);
        Conversation conversation = new Conversation(client);
        conversation.begin(_ -> {}, () -> {});
        completion = new Completion(new Vocabulary(catalogue), new KnownNames(conversation));
    }

    @AfterEach
    void end() {
        client.close();
        simulator.close();
    }

    private List<String> offered(String line) throws IOException {
        LineReader reader =
                LineReaderBuilder.builder()
                        .terminal(
                                new DumbTerminal(
                                        InputStream.nullInputStream(), new ByteArrayOutputStream()))
                        .build();
        List<Candidate> candidates = new ArrayList<>();
        completion.complete(
                reader,
                new DefaultParser().parse(line, line.length(), ParseContext.COMPLETE),
                candidates);
        return candidates.stream().map(Candidate::value).toList();
    }

    @Test
    void wordsOfCommands() throws IOException {
        assertThat(offered("")).contains("pause", "set", "list", "add", "help", "exit");
        assertThat(offered("list ")).contains("effects", "world").doesNotContain("help");
        assertThat(offered("help add ")).contains("effect", "field").doesNotContain("<gravity");
    }

    @Test
    void namesOfObjectsForTheirIds() throws IOException {
        assertThat(offered("set propulsor ")).containsExactly("Red Fish");
        assertThat(offered("remove entity ")).containsExactly("Red Fish");
    }

    @Test
    void whatElseHasAName() throws IOException {
        assertThat(offered("set propulsor \"Red Fish\" ")).containsExactly("Tail");
        assertThat(offered("disconnect client ")).containsExactly("client 1");
        assertThat(offered("restore snapshot ")).isEmpty();
    }

    @Test
    void valuesAndElements() throws IOException {
        assertThat(offered("apply direct force 1 push ")).contains("WORLD", "BODY");
        assertThat(offered("add effect 1 ")).contains("<gravity", "<damping");
        assertThat(offered("pause ")).isEmpty();
    }

    @Test
    void nothingOfObjectsWhenTheSimulatorHasGone() throws IOException {
        simulator.close();
        assertThat(offered("take control ")).isEmpty();
    }
}
