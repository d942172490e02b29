package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.message.control.ShutdownSimulatorCommand;

import picocli.CommandLine;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PipedReader;
import java.io.PipedWriter;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;

/** {@code auvsim serve} on a free port, on a thread of its own. */
final class ServerProcess implements AutoCloseable {
    private final CompletableFuture<Integer> code;
    private final int port;

    /** Serves a scenario; returns once it listens. */
    ServerProcess(Path scenario, String... options) throws IOException {
        List<String> arguments =
                new ArrayList<>(List.of("serve", scenario.toString(), "--port", "0"));
        arguments.addAll(List.of(options));
        StringWriter err = new StringWriter();
        PipedWriter out = new PipedWriter();
        BufferedReader said = new BufferedReader(new PipedReader(out));
        Path temporary = Path.of(System.getProperty("java.io.tmpdir"));
        CommandLine line =
                Auvsim.commandLine(temporary, temporary)
                        .setOut(new PrintWriter(out))
                        .setErr(new PrintWriter(err));
        code = CompletableFuture.supplyAsync(() -> line.execute(arguments.toArray(String[]::new)));
        String first = said.readLine();
        port = Integer.parseInt(first.substring(first.lastIndexOf(':') + 1));
    }

    int port() {
        return port;
    }

    String address() {
        return "127.0.0.1:" + port;
    }

    /** Waits for its end. */
    int exitCode() {
        return code.join();
    }

    /** Ends it as a client does, and waits for its end. */
    @Override
    public void close() {
        try (AuvsmlClient client = AuvsmlClient.connect("127.0.0.1", port)) {
            client.send(new ShutdownSimulatorCommand());
        } catch (ConnectionException _) {
            // Nobody is there any more: it has reached its --until.
            assertThat(code).succeedsWithin(Duration.ofSeconds(30));
        }
        code.join();
    }
}
