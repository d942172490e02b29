package org.auvsim.cli;

import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.message.command.EventType;
import org.auvsim.auvsml.message.control.GetSimulatorStateRequest;
import org.auvsim.auvsml.message.control.ResumeSimulatorCommand;
import org.auvsim.auvsml.message.control.SimulatorStateResponse;
import org.auvsim.auvsml.message.listening.ListenerRegistrationRequestCommand;
import org.auvsim.cli.feed.FeedTally;
import org.auvsim.cli.feed.LogException;
import org.auvsim.cli.feed.LogFrame;
import org.auvsim.cli.feed.LogPlayer;
import org.auvsim.cli.feed.LogReader;
import org.auvsim.cli.feed.MeasuredLog;
import org.auvsim.cli.report.FileTrouble;
import org.auvsim.cli.report.UserError;

import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;

/** {@code auvsim feed}. */
@Command(
        name = "feed",
        description = "Plays a measured log to a simulator as a robot's position feedback.",
        footer = {
            "",
            "Each projected movement is answered with the position measured at its time (linear"
                + " between two samples), if a sample has come since the last answer. At the end"
                + " the simulated path is compared with the samples that were held back.",
            "",
            "Example: auvsim feed zigzag.csv --object ship --columns t=time_s,x=x0_m,y=y0_m"
                    + " --frame ned --every 2"
        })
final class Feed implements Callable<Integer> {
    @Spec private CommandSpec spec;

    @Parameters(
            index = "0",
            paramLabel = "LOG",
            description = "CSV with a header line; times in seconds, positions in metres.")
    private Path file;

    @Mixin private final Connection connection = new Connection();

    @Option(
            names = "--object",
            required = true,
            paramLabel = "NAME|ID",
            description = "The world object that was measured.")
    private String object = "";

    @Option(
            names = "--columns",
            split = ",",
            paramLabel = "KEY=NAME",
            description =
                    "Names of the log's columns for t, x, y and z, as t=time_s,x=x0_m;"
                            + " without a z all heights are 0.")
    private Map<String, String> columns = new LinkedHashMap<>();

    @Option(
            names = "--frame",
            paramLabel = "FRAME",
            defaultValue = "enu",
            description =
                    "The log's axes: enu (x east, y north, z up) or ned (x north, y east, z"
                            + " down); by default ${DEFAULT-VALUE}.")
    private LogFrame frame = LogFrame.ENU;

    @Option(
            names = "--handler",
            paramLabel = "NAME",
            defaultValue = "DirectPositionChangeFeedbackHandler",
            completionCandidates = Handlers.class,
            description =
                    "The feedback processor to ask for: ${COMPLETION-CANDIDATES}, or one that"
                            + " the simulator was extended with; by default ${DEFAULT-VALUE}.")
    private String handler = "";

    @Option(
            names = "--every",
            paramLabel = "N",
            defaultValue = "1",
            description =
                    "Sends each N-th sample only and holds the others back; 0 sends none and"
                            + " only compares. By default ${DEFAULT-VALUE}.")
    private int every;

    @Option(
            names = "--resume",
            description =
                    "Lets a simulator that was started with 'serve --paused' go on as soon as"
                            + " this client listens.")
    private boolean resume;

    @Override
    public Integer call() throws ConnectionException {
        if (every < 0) {
            throw new UserError("--every must be 0 or more, but is %d.".formatted(every));
        }
        MeasuredLog log = read();
        try (AuvsmlClient client = connection.open();
                Interruption _ = new Interruption(client::close)) {
            ServedObject fed = ServedObject.named(ServedObject.all(client), object);
            double start = begin(client, log);
            prepare(client, fed);
            FeedTally tally = new LogPlayer(client, fed.id(), handler, log, every, start).play();
            PrintWriter out = spec.commandLine().getOut();
            tally.report().forEach(out::println);
            out.flush();
            requireUse(tally, fed);
        }
        return 0;
    }

    /** The simulator's time (s), which must be before the log's end. */
    private double begin(AuvsmlClient client, MeasuredLog log) throws ConnectionException {
        SimulatorStateResponse state =
                Question.ask(client, new GetSimulatorStateRequest()).stream()
                        .filter(SimulatorStateResponse.class::isInstance)
                        .map(SimulatorStateResponse.class::cast)
                        .findFirst()
                        .orElseThrow(() -> new UserError("The simulator does not say its time."));
        if (state.time() >= log.end()) {
            throw new UserError(
                    "The simulator is at %s s already, but the log ends at %s s: start it with"
                                    .formatted(state.time(), log.end())
                            + " 'serve --paused' and feed with --resume.");
        }
        if (!state.running() && !resume) {
            PrintWriter err = spec.commandLine().getErr();
            err.println(
                    "the simulator is paused: waiting until a client resumes it (--resume does)");
            err.flush();
        }
        return state.time();
    }

    private static void requireUse(FeedTally tally, ServedObject fed) {
        if (!tally.moved()) {
            throw new UserError(
                    "The simulator said nothing of a movement of '%s': it is fixed, or has left."
                            .formatted(fed.name()));
        }
        if (tally.sent() > 0 && tally.applied() == 0) {
            throw new UserError(
                    "None of the %d samples sent was applied%s."
                            .formatted(
                                    tally.sent(),
                                    tally.refusal().map(text -> ": " + text).orElse("")));
        }
    }

    private MeasuredLog read() {
        try {
            return new LogReader(file, columns, frame).read();
        } catch (IOException e) {
            throw FileTrouble.reading(file, e);
        } catch (LogException e) {
            throw new UserError(String.valueOf(e.getMessage()), e);
        }
    }

    private void prepare(AuvsmlClient client, ServedObject fed) throws ConnectionException {
        Question.ask(
                client,
                ListenerRegistrationRequestCommand.of(
                        Long.toString(fed.id()),
                        List.of(
                                EventType.PROJECTED_MOVEMENT,
                                EventType.MOVEMENT_STATE_CHANGE,
                                EventType.TIMESTEP_ADVANCED,
                                EventType.FEEDBACK_APPLIED)));
        if (resume) {
            client.send(new ResumeSimulatorCommand());
        }
    }

    private static final class Handlers implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return List.of("DirectPositionChangeFeedbackHandler", "VectorAdjustmentFeedbackHandler")
                    .iterator();
        }
    }
}
