package org.auvsim.cli;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.client.Received;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.EventType;
import org.auvsim.auvsml.message.command.ListenedObject;
import org.auvsim.auvsml.message.listening.ListenerRegistrationRequestCommand;

import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

import java.io.PrintWriter;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.Stream;

/** {@code auvsim watch}. */
@Command(
        name = "watch",
        description = "Shows what moves in a simulator, until that ends or Ctrl-C.",
        footer = {
            "",
            "A line is a movement: time (s), object, whether the step was made (actual) or is"
                + " announced (projected), position (m), roll, pitch and yaw (degrees). Collisions,"
                + " what comes and goes, and feedback that was applied have lines of their own.",
            "",
            "Example: auvsim watch --object AUV-1701"
        })
final class Watch implements Callable<Integer> {
    private static final List<EventType> SHOWN =
            List.of(
                    EventType.PROJECTED_MOVEMENT,
                    EventType.MOVEMENT_STATE_CHANGE,
                    EventType.COLLISION,
                    EventType.SENSOR_READING,
                    EventType.RADIO,
                    EventType.ENTITY_ADDED,
                    EventType.ENTITY_REMOVED,
                    EventType.FEEDBACK_APPLIED);

    @Spec private CommandSpec spec;

    @Mixin private final Connection connection = new Connection();

    @Option(names = "--xml", description = "Prints every message as it came.")
    private boolean xml;

    @Option(
            names = "--object",
            paramLabel = "NAME|ID",
            description = "Watches one world object only.")
    private Optional<String> object = Optional.empty();

    @Option(
            names = "--steps",
            description =
                    "Tells also what kept a step from getting stuck or diverging: sub-steps,"
                            + " contacts held, quick hits, crowded hits, lowered hits, islands"
                            + " unsolved.")
    private boolean steps;

    @Override
    public Integer call() throws ConnectionException {
        try (AuvsmlClient client = connection.open();
                Interruption _ = new Interruption(client::close)) {
            List<ServedObject> objects = ServedObject.all(client);
            String watched =
                    object.map(name -> Long.toString(ServedObject.named(objects, name).id()))
                            .orElse(ListenedObject.EVERY);
            if (xml) {
                client.send(ListenerRegistrationRequestCommand.ofAll(watched));
                printText(client);
            } else {
                client.send(ListenerRegistrationRequestCommand.of(watched, shown()));
                printLines(client, new EventLines(objects));
            }
        }
        return 0;
    }

    private List<EventType> shown() {
        return steps
                ? Stream.concat(SHOWN.stream(), Stream.of(EventType.STEP_REPORT)).toList()
                : SHOWN;
    }

    private void printText(AuvsmlClient client) throws ConnectionException {
        PrintWriter out = spec.commandLine().getOut();
        Optional<String> text = client.nextText();
        while (text.isPresent() && !out.checkError()) {
            out.println(text.get());
            text = client.nextText();
        }
    }

    private void printLines(AuvsmlClient client, EventLines lines) throws ConnectionException {
        PrintWriter out = spec.commandLine().getOut();
        out.println(EventLines.HEADER);
        Optional<Received> received = client.next();
        while (received.isPresent() && !out.checkError()) {
            for (Message message : received.get().messages()) {
                lines.of(message).ifPresent(out::println);
            }
            received = client.next();
        }
        out.flush();
    }
}
