package org.auvsim.checks.launcher;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;

/** A launcher that was started. */
final class Running {
    private final Process process;
    private final BufferedReader err;

    Running(Process process) {
        this.process = process;
        err = new BufferedReader(new InputStreamReader(process.getErrorStream(), UTF_8));
    }

    /** Waits for the next line that it says on its error stream. */
    String nextError() throws IOException {
        String line = err.readLine();
        if (line == null) {
            throw new IOException("the launcher ended without a word");
        }
        return line;
    }

    /** Waits for its end; what is still unread of its streams is in the answer. */
    Run end() throws IOException, InterruptedException {
        String out = new String(process.getInputStream().readAllBytes(), UTF_8);
        String rest = err.readAllAsString();
        return new Run(process.waitFor(), out, rest);
    }
}
