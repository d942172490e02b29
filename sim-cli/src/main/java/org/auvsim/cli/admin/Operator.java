package org.auvsim.cli.admin;

import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.client.TooLongException;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.session.ErrorResponse;
import org.auvsim.cli.report.UserError;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;

/** Does what one line after the other asks for, and says what came of it. */
final class Operator {
    private static final Set<String> LEAVING = Set.of("exit", "quit");

    private final Conversation conversation;
    private final Interpreter interpreter;
    private final Help help;
    private final PlainText text;
    private final Consumer<String> out;

    Operator(
            Conversation conversation,
            Interpreter interpreter,
            Help help,
            PlainText text,
            Consumer<String> out) {
        this.conversation = conversation;
        this.interpreter = interpreter;
        this.help = help;
        this.text = text;
        this.out = out;
    }

    /** Whether a line asks to leave the shell; the simulation goes on. */
    static boolean isLeaving(String line) {
        return LEAVING.contains(line.strip());
    }

    /**
     * Does what a line asks for; nothing if it is blank or a comment.
     *
     * @param patience how long the answer is waited for
     * @throws UserError if the line means nothing, or the simulator refuses, with the reason
     */
    void perform(String line, Duration patience) throws ConnectionException, InterruptedException {
        String command = line.strip();
        if (command.isEmpty() || command.startsWith("#")) {
            return;
        }
        if (command.equals("help") || command.startsWith("help ")) {
            out.accept(help.on(command.substring("help".length()).strip()));
            return;
        }
        List<Message> messages = interpreter.messages(command);
        List<Message> answers = asked(messages, patience);
        for (Message answer : answers) {
            if (answer instanceof ErrorResponse error) {
                throw new UserError("refused: " + error.text());
            }
            out.accept(text.of(answer));
        }
        if (answers.size() < messages.size() && !conversation.hasEnded()) {
            out.accept("waits for its turn; the answer is shown when it comes");
        }
    }

    private List<Message> asked(List<Message> messages, Duration patience)
            throws ConnectionException, InterruptedException {
        try {
            return conversation.ask(messages, patience);
        } catch (TooLongException e) {
            throw new UserError("not sent: " + e.getMessage());
        }
    }
}
