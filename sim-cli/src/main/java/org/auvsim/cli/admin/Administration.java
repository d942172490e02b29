package org.auvsim.cli.admin;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.Message;
import org.jline.reader.LineReader;
import org.jline.reader.LineReaderBuilder;
import org.jline.reader.impl.DefaultParser;
import org.jline.terminal.Terminal;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;

/** An administrator's commands to a simulator, from a terminal or from lines. */
public final class Administration {
    private final AuvsmlClient client;
    private final MessageCatalogue catalogue;
    private final Vocabulary vocabulary;
    private final PlainText text;

    /** Over a connection that stays the caller's to close. */
    public Administration(AuvsmlClient client, MessageCatalogue catalogue) {
        this.client = client;
        this.catalogue = catalogue;
        this.vocabulary = new Vocabulary(catalogue);
        this.text = new PlainText(catalogue);
    }

    /**
     * Performs lines until they end or one asks to leave; notices of the simulator stand between
     * the answers.
     *
     * @throws org.auvsim.cli.report.UserError at the first fault, with the line's number
     */
    public void perform(BufferedReader lines, PrintWriter out)
            throws IOException, InterruptedException {
        Consumer<String> print = printer(out);
        Conversation conversation = new Conversation(client);
        KnownNames names = new KnownNames(conversation);
        conversation.begin(notice -> print.accept(told(notice)), () -> {});
        try {
            new Script(lines, conversation, operator(conversation, names, print)).run();
        } finally {
            conversation.farewell().ifPresent(last -> print.accept(told(last)));
        }
    }

    /**
     * Reads and performs lines of a person, who leaves or is left by the simulator; notices are
     * shown above the line that is being typed.
     *
     * @param history the file that holds what was typed, from session to session
     */
    public void converse(Terminal terminal, Path history) throws InterruptedException {
        Conversation conversation = new Conversation(client);
        KnownNames names = new KnownNames(conversation);
        LineReader reader = reader(terminal, history, names);
        PrintWriter out = terminal.writer();
        Consumer<String> print = printer(out);
        CountDownLatch left = new CountDownLatch(1);
        conversation.begin(
                notice -> reader.printAbove(told(notice)),
                () -> Thread.startVirtualThread(() -> interrupt(terminal, left)));
        try {
            new Shell(reader, conversation, operator(conversation, names, print)).run();
        } finally {
            left.countDown();
        }
        conversation.farewell().ifPresent(last -> print.accept(told(last)));
    }

    /** Again and again: a signal that comes just before a line begins to be read is lost. */
    private static void interrupt(Terminal terminal, CountDownLatch left) {
        try {
            do {
                terminal.raise(Terminal.Signal.INT);
            } while (!left.await(100, TimeUnit.MILLISECONDS));
        } catch (InterruptedException _) {
            Thread.currentThread().interrupt();
        }
    }

    private LineReader reader(Terminal terminal, Path history, KnownNames names) {
        DefaultParser parser = new DefaultParser();
        parser.setEscapeChars(new char[0]);
        return LineReaderBuilder.builder()
                .terminal(terminal)
                .appName("auvsim")
                .parser(parser)
                .completer(new Completion(vocabulary, names))
                .variable(LineReader.HISTORY_FILE, history)
                .option(LineReader.Option.DISABLE_EVENT_EXPANSION, true)
                .build();
    }

    private Operator operator(Conversation conversation, KnownNames names, Consumer<String> print) {
        return new Operator(
                conversation,
                new Interpreter(catalogue, vocabulary, names),
                new Help(vocabulary),
                text,
                print);
    }

    private static Consumer<String> printer(PrintWriter out) {
        return line -> {
            out.println(line);
            out.flush();
        };
    }

    private String told(Message notice) {
        return "* " + text.of(notice);
    }
}
