package org.auvsim.cli;

import static java.nio.charset.StandardCharsets.UTF_8;

import de.siegmar.fastcsv.writer.CsvWriter;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.client.AuvsmlClient;
import org.auvsim.auvsml.client.ConnectionException;
import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.EventType;
import org.auvsim.auvsml.message.command.ListenedObject;
import org.auvsim.auvsml.message.control.GetSimulatorStateRequest;
import org.auvsim.auvsml.message.control.ResumeSimulatorCommand;
import org.auvsim.auvsml.message.control.SimulatorStateResponse;
import org.auvsim.auvsml.message.control.TakeControlCommand;
import org.auvsim.auvsml.message.listening.ListenerRegistrationRequestCommand;
import org.auvsim.auvsml.message.lockstep.HelloCommand;
import org.auvsim.auvsml.message.lockstep.HelloResponse;
import org.auvsim.cli.mirror.MirrorTally;
import org.auvsim.cli.mirror.MirrorWorld;
import org.auvsim.cli.mirror.Mirroring;
import org.auvsim.cli.report.FileTrouble;
import org.auvsim.cli.report.UserError;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;

import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.TreeMap;
import java.util.concurrent.Callable;

/** {@code auvsim mirror}: a second simulator beside a first one (thesis, section 9.3). */
@Command(
        name = "mirror",
        description =
                "Runs a world of its own beside a simulator's, compares the objects that have the"
                        + " same names in both, and corrects the simulator's with its own.",
        footer = {
            "",
            "The scenario is the other model: the same objects, with other effects, a finer step or"
                + " another stepper. Each projected movement is answered with the mirror's full"
                + " motion at its time; a simulator that projects nothing is answered after each"
                + " step, and one in lock-step waits for the mirror. At the end a table says how"
                + " far the two were apart.",
            "",
            "Example: auvsim mirror finer.xml --observe --csv apart.csv"
        })
final class Mirror implements Callable<Integer> {
    @Spec private CommandSpec spec;

    @Parameters(index = "0", paramLabel = "SCENARIO", description = "The mirror's own world.")
    private Path file;

    @Mixin private final Connection connection = new Connection();

    @Option(names = "--observe", description = "Compares only, and corrects nothing.")
    private boolean observe;

    @Option(
            names = "--processor",
            paramLabel = "NAME",
            defaultValue = "DirectPositionChangeFeedbackHandler",
            description = "The feedback processor to ask for; by default ${DEFAULT-VALUE}.")
    private String processor = "";

    @Option(
            names = "--csv",
            paramLabel = "FILE",
            description = "Writes each comparison: time, name, both positions, distance.")
    private Optional<Path> csv = Optional.empty();

    @Option(
            names = "--resume",
            description =
                    "Lets a simulator that was started with 'serve --paused' go on as soon as"
                            + " this client listens.")
    private boolean resume;

    @Override
    public Integer call() throws DocumentException, ConnectionException {
        Scenario scenario = ScenarioFile.load(file, spec.commandLine().getErr());
        try (AuvsmlClient client = connection.open();
                Interruption _ = new Interruption(client::close)) {
            MirrorWorld mirror = mirror(scenario, ServedObject.all(client));
            if (!resume) {
                tellIfPaused(client);
            }
            listen(client);
            OptionalLong step = join(client, mirror);
            if (resume) {
                client.send(new ResumeSimulatorCommand());
            }
            if (csv.isPresent()) {
                runAndWrite(client, mirror, step, csv.get());
            } else {
                run(new Mirroring(client, mirror, step, processor(), (_, _, _, _) -> {}));
            }
        }
        return 0;
    }

    private void tellIfPaused(AuvsmlClient client) throws ConnectionException {
        for (Message message : Question.ask(client, new GetSimulatorStateRequest())) {
            if (message instanceof SimulatorStateResponse state && !state.running()) {
                PrintWriter err = spec.commandLine().getErr();
                err.println(
                        "the simulator is paused; resume it, or start the mirror with --resume");
                err.flush();
            }
        }
    }

    private Optional<String> processor() {
        return observe ? Optional.empty() : Optional.of(processor);
    }

    /**
     * The mirror's world.
     *
     * @throws UserError if it has no object in common with the simulator
     */
    private MirrorWorld mirror(Scenario scenario, List<ServedObject> objects) {
        Map<Long, String> served = new TreeMap<>();
        objects.forEach(object -> served.put(object.id(), object.name()));
        World own = scenario.world();
        MirrorWorld mirror = new MirrorWorld(own, served);
        if (mirror.common().isEmpty()) {
            List<String> here = own.objects().stream().map(WorldObject::name).toList();
            throw new UserError(
                    "%s and the simulator have no object of one name: here %s, there %s."
                            .formatted(file, listed(here), listed(served.values())));
        }
        return mirror;
    }

    private static String listed(Collection<String> names) {
        return names.isEmpty() ? "are none" : "'" + String.join("', '", names) + "'";
    }

    private void listen(AuvsmlClient client) throws ConnectionException {
        List<EventType> events =
                new ArrayList<>(
                        List.of(
                                EventType.MOVEMENT_STATE_CHANGE,
                                EventType.PROJECTED_MOVEMENT,
                                EventType.TIMESTEP_ADVANCED));
        if (!observe) {
            events.add(EventType.FEEDBACK_APPLIED);
        }
        Question.ask(client, ListenerRegistrationRequestCommand.of(ListenedObject.EVERY, events));
    }

    /**
     * Becomes a member of a simulation in lock-step, under the name that this client has. What is
     * to be corrected is taken first: feedback for all that a member controls is its answer, so
     * that what it corrects without control would come too late.
     *
     * @return the first step to answer; empty if this client may only look on
     */
    private OptionalLong join(AuvsmlClient client, MirrorWorld mirror) throws ConnectionException {
        boolean mayJoin =
                Role.named(client.welcome().role())
                        .filter(role -> role.allows(Role.CONTROLLER))
                        .isPresent();
        if (!mayJoin) {
            return OptionalLong.empty();
        }
        if (!observe) {
            for (long id : mirror.movable()) {
                client.send(new TakeControlCommand(id));
            }
        }
        String name = "client " + client.welcome().sessionId();
        for (Message message : Question.ask(client, new HelloCommand(name))) {
            if (message instanceof HelloResponse hello) {
                return OptionalLong.of(hello.step());
            }
        }
        return OptionalLong.empty();
    }

    private void runAndWrite(AuvsmlClient client, MirrorWorld mirror, OptionalLong step, Path to)
            throws ConnectionException {
        try (CsvWriter rows = CsvWriter.builder().build(to, UTF_8)) {
            rows.writeRecord(
                    "time_s",
                    "object",
                    "served_x_m",
                    "served_y_m",
                    "served_z_m",
                    "mirrored_x_m",
                    "mirrored_y_m",
                    "mirrored_z_m",
                    "distance_m");
            run(
                    new Mirroring(
                            client,
                            mirror,
                            step,
                            processor(),
                            (time, name, served, mirrored) ->
                                    write(rows, time, name, served, mirrored)));
        } catch (ConnectionException e) {
            throw e;
        } catch (IOException e) {
            throw FileTrouble.writing(to, e);
        } catch (UncheckedIOException e) {
            throw FileTrouble.writing(to, new IOException(e.getMessage(), e));
        }
    }

    private static void write(
            CsvWriter rows, double time, String name, Vec3 served, Vec3 mirrored) {
        rows.writeRecord(
                Double.toString(time),
                name,
                Double.toString(served.x()),
                Double.toString(served.y()),
                Double.toString(served.z()),
                Double.toString(mirrored.x()),
                Double.toString(mirrored.y()),
                Double.toString(mirrored.z()),
                Double.toString(served.distance(mirrored)));
    }

    /** Goes along to the end, and tells what came of it, also when the simulator breaks off. */
    private void run(Mirroring mirroring) throws ConnectionException {
        try {
            mirroring.run();
        } finally {
            tell(mirroring.tally());
        }
        requireUse(mirroring.tally());
    }

    private void tell(MirrorTally tally) {
        PrintWriter out = spec.commandLine().getOut();
        tally.report().forEach(out::println);
        out.flush();
    }

    private static void requireUse(MirrorTally tally) {
        if (tally.rows().isEmpty()) {
            throw new UserError(
                    "The simulator told of no movement of the objects that both have: they are"
                            + " fixed or at rest, or it stood still.");
        }
        if (tally.sent() > 0 && tally.applied() == 0) {
            throw new UserError("None of the %d corrections was applied.".formatted(tally.sent()));
        }
    }
}
