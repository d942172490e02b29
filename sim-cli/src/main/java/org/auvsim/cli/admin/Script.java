package org.auvsim.cli.admin;

import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.cli.report.UserError;

import java.io.BufferedReader;
import java.io.IOException;
import java.time.Duration;

/** Lines from a pipe or a file: the first fault ends it. */
final class Script {
    private static final Duration FOR_EVER = Duration.ofNanos(Long.MAX_VALUE);

    private final BufferedReader lines;
    private final Conversation conversation;
    private final Operator operator;

    Script(BufferedReader lines, Conversation conversation, Operator operator) {
        this.lines = lines;
        this.conversation = conversation;
        this.operator = operator;
    }

    /**
     * Performs all lines.
     *
     * @throws UserError at the first fault, with the line's number
     */
    void run() throws IOException, InterruptedException {
        int number = 1;
        for (String line = lines.readLine(); line != null; line = lines.readLine()) {
            if (Operator.isLeaving(line)) {
                return;
            }
            perform(line, number++);
        }
    }

    private void perform(String line, int number) throws InterruptedException {
        try {
            if (conversation.hasEnded()) {
                throw new UserError("the simulator has ended the connection");
            }
            operator.perform(line, FOR_EVER);
        } catch (UserError | ConnectionException e) {
            throw new UserError("line %d: %s".formatted(number, e.getMessage()), e);
        }
    }
}
