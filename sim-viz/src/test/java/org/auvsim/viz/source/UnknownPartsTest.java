package org.auvsim.viz.source;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.entity.DescribeWorldObjectRequest;
import org.auvsim.viz.scene.Occurrence;
import org.auvsim.viz.scene.SeenObject;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.List;
import java.util.Scanner;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A simulator whose extensions the viewer lacks, over a real socket. */
@Timeout(60)
class UnknownPartsTest {
    private static final Pattern REQUEST = Pattern.compile("request-id=\"([^\"]*)\"><([a-z-]*)");

    @Test
    void anEffectThatIsNotKnownIsToldOnce() throws Exception {
        try (LiveSource source = connected("<sphere radius=\"1\"/><levity up=\"3\"/>")) {
            SeenObject buoy = source.scene().object(1).orElseThrow();
            assertThat(buoy.definition().orElseThrow().effect()).isEmpty();
            assertThat(told(source))
                    .containsExactly(
                            "Buoy has <levity>, which this viewer does not know and does not show:"
                                    + " start it with the simulator's --extensions.");
        }
    }

    @Test
    void anObjectWhoseVolumeIsNotKnownIsThereByItsName() throws Exception {
        try (LiveSource source = connected("<blob size=\"3\"/>")) {
            SeenObject buoy = source.scene().object(1).orElseThrow();
            assertThat(buoy.name()).isEqualTo("Buoy");
            assertThat(buoy.definition()).isEmpty();
            assertThat(source.isConnected()).isTrue();
            assertThat(told(source))
                    .containsExactly(
                            "Buoy has <blob>, without which this viewer shows it as a small box:"
                                    + " start it with the simulator's --extensions.");
        }
    }

    @Test
    void aSimulatorThatDoesNotTellWhatThereIsIsNoneToSee() throws Exception {
        String refusal = "<error-response code=\"NOT_ALLOWED\" text=\"Nothing is told here.\"/>";
        try (LiveSource source = connected("guest", request -> refusal)) {
            assertThatThrownBy(() -> source.ready().get())
                    .hasCauseInstanceOf(RefusedException.class)
                    .hasMessageContaining("Nothing is told here.");
            assertThat(source.role()).isEqualTo(Role.VIEWER);
        }
    }

    private static List<String> told(LiveSource source) throws Exception {
        // It is described more than once.
        source.ask(new DescribeWorldObjectRequest(1)).handle((answer, refusal) -> true).get();
        return source.scene().drainOccurrences().stream().map(Occurrence::text).toList();
    }

    private static LiveSource connected(String parts) throws Exception {
        LiveSource source = connected("admin", request -> answer(request, parts));
        source.ready().get();
        return source;
    }

    private static LiveSource connected(String role, UnaryOperator<String> answers)
            throws Exception {
        ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        Thread.startVirtualThread(() -> serve(server, role, answers));
        return LiveSource.connect(
                "127.0.0.1",
                server.getLocalPort(),
                MessageCatalogue.load(UnknownPartsTest.class.getClassLoader()));
    }

    /** Answers one client until it goes. */
    private static void serve(ServerSocket server, String role, UnaryOperator<String> answers) {
        try (server;
                Socket client = server.accept();
                InputStream in = client.getInputStream();
                Scanner roots = new Scanner(in, UTF_8).useDelimiter("</auvsml>")) {
            write(
                    client,
                    "<auvsml><welcome-message protocol-version=\"1\" server=\"x\" session-id=\"1\""
                            + " role=\"%s\"/></auvsml>".formatted(role));
            while (roots.hasNext()) {
                Matcher request = REQUEST.matcher(roots.next());
                if (request.find()) {
                    write(
                            client,
                            "<auvsml request-id=\"%s\">%s</auvsml>"
                                    .formatted(request.group(1), answers.apply(request.group(2))));
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void write(Socket to, String text) throws IOException {
        to.getOutputStream().write(text.getBytes(UTF_8));
    }

    private static String answer(String request, String parts) {
        return switch (request) {
            case "get-field-list-request" -> "<field-list-response/>";
            case "get-world-object-list-command" ->
                    "<world-object-list-response><world-object id=\"1\" name=\"Buoy\" type=\"x\"/>"
                            + "</world-object-list-response>";
            case "describe-world-object-request" ->
                    "<world-object-description-response><world-object id=\"1\" name=\"Buoy\""
                            + " mass=\"2\">"
                            + parts
                            + "</world-object></world-object-description-response>";
            default -> "<command-done-response/>";
        };
    }
}
