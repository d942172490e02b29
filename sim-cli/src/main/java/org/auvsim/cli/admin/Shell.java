package org.auvsim.cli.admin;

import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.cli.report.UserError;
import org.jline.reader.EndOfFileException;
import org.jline.reader.LineReader;
import org.jline.reader.UserInterruptException;

import java.time.Duration;

/** A person at a terminal: faults are told, and the next line is read. */
final class Shell {
    private static final String PROMPT = "auvsim> ";

    /** A person is not kept waiting for longer: commands may wait for the end of a step. */
    private static final Duration PATIENCE = Duration.ofSeconds(3);

    private final LineReader reader;
    private final Conversation conversation;
    private final Operator operator;

    Shell(LineReader reader, Conversation conversation, Operator operator) {
        this.reader = reader;
        this.conversation = conversation;
        this.operator = operator;
    }

    /** Reads lines until the person leaves or the simulator does. */
    void run() throws InterruptedException {
        while (!conversation.hasEnded()) {
            try {
                String line = reader.readLine(PROMPT);
                if (Operator.isLeaving(line)) {
                    return;
                }
                operator.perform(line, PATIENCE);
            } catch (UserInterruptException _) {
                // Ctrl-C: the line is given up
            } catch (EndOfFileException _) {
                return;
            } catch (UserError | ConnectionException e) {
                reader.printAbove(String.valueOf(e.getMessage()));
            }
        }
    }
}
