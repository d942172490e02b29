package org.auvsim.server.simulator;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.document.FeedbackProcessorChoice;
import org.auvsim.auvsml.document.ReleasedObject;
import org.auvsim.auvsml.framing.AuvsmlWriter;
import org.auvsim.auvsml.framing.RootDecoder;
import org.auvsim.auvsml.mapping.ContextClasses;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.auvsml.xml.Limits;
import org.auvsim.core.world.World;
import org.auvsim.server.feedback.FeedbackProcessor;
import org.auvsim.server.feedback.FeedbackProcessors;
import org.auvsim.server.feedback.FeedbackTimestepper;
import org.auvsim.server.feedback.NoFeedbackTimestepper;
import org.auvsim.server.net.Transport;
import org.auvsim.server.net.TransportException;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.LongSupplier;

/** Collects what a simulator is made of; everything has a default. */
public final class SimulatorBuilder {
    /** So many inputs may wait for the simulation thread. */
    private static final int MAILBOX_CAPACITY = 1024;

    /** Viewers of a replay have ids beyond those of the sessions that are replayed. */
    private static final long FIRST_VIEWER = 1_000_000_001;

    private final World world;
    private final List<Transport> transports = new ArrayList<>();
    private final FeedbackProcessors processors = FeedbackProcessors.standard();
    private FeedbackTimestepper timestepper = new NoFeedbackTimestepper();
    private final List<InputLog> logs = new ArrayList<>();
    private double horizon;
    private ReleasedObject released = ReleasedObject.UNCHANGED;
    private OptionalDouble rate = OptionalDouble.of(1);
    private OptionalDouble until = OptionalDouble.empty();
    private List<FeedbackProcessor> stated = List.of();
    private Optional<String> override = Optional.empty();
    private boolean running = true;
    private Role role = Role.ADMIN;
    private Optional<MessageCatalogue> catalogue = Optional.empty();
    private Limits limits = Limits.MESSAGE;
    private String serverName = "auvsim";
    private LongSupplier nanoClock = System::nanoTime;

    SimulatorBuilder(World world) {
        this.world = world;
    }

    /** Adds a way by which clients come; without one the simulator is only embedded. */
    public SimulatorBuilder transport(Transport transport) {
        transports.add(transport);
        return this;
    }

    /** World seconds a second; empty: as fast as possible. Real time by default. */
    public SimulatorBuilder rate(OptionalDouble rate) {
        this.rate = rate;
        return this;
    }

    /** How steps are made and feedback comes into them; by default feedback is ignored. */
    public SimulatorBuilder timestepper(FeedbackTimestepper timestepper) {
        this.timestepper = timestepper;
        return this;
    }

    /**
     * How far back (s) feedback may be true that comes late: the steps since then are made again
     * with it. By default 0, and it is refused.
     *
     * @throws IllegalArgumentException if it is negative or not finite
     */
    public SimulatorBuilder feedbackHorizon(double horizon) {
        if (!(horizon >= 0 && Double.isFinite(horizon))) {
            throw new IllegalArgumentException(
                    "the feedback horizon must be 0 s or more, but is " + horizon + " s");
        }
        this.horizon = horizon;
        return this;
    }

    /** What becomes of objects that clients let go; by default nothing. */
    public SimulatorBuilder releasedObject(ReleasedObject released) {
        this.released = released;
        return this;
    }

    /** Lets a log hear of all that decides how the simulation goes on. */
    public SimulatorBuilder log(InputLog log) {
        logs.add(log);
        return this;
    }

    /** Adds a feedback processor, in place of one of the same name. */
    public SimulatorBuilder processor(FeedbackProcessor processor) {
        processors.add(processor);
        return this;
    }

    /** Lets processors work as a scenario states. */
    SimulatorBuilder processors(FeedbackProcessorChoice choice) {
        stated = ScenarioSettings.processors(choice);
        override = choice.override();
        return this;
    }

    /** Lets the processor of this name do all corrections, whichever the messages name. */
    public SimulatorBuilder overrideProcessors(String name) {
        override = Optional.of(name);
        return this;
    }

    /** Ends the simulation when the world has reached this time (s). */
    public SimulatorBuilder until(OptionalDouble worldTime) {
        this.until = worldTime;
        return this;
    }

    /** Stands still until a client or {@link Simulator#resume} lets it go on. */
    public SimulatorBuilder paused() {
        running = false;
        return this;
    }

    /** What those who connect may do; by default everything: they do not prove who they are. */
    public SimulatorBuilder role(Role role) {
        this.role = role;
        return this;
    }

    /** The messages that clients may send; by default those that provider files name. */
    public SimulatorBuilder catalogue(MessageCatalogue catalogue) {
        this.catalogue = Optional.of(catalogue);
        return this;
    }

    /** How long and how deep messages may be. */
    public SimulatorBuilder limits(Limits limits) {
        this.limits = limits;
        return this;
    }

    /** What the welcome message says of the server: its name and version. */
    public SimulatorBuilder serverName(String serverName) {
        this.serverName = serverName;
        return this;
    }

    /** The wall's clock (ns), for tests. */
    SimulatorBuilder nanoClock(LongSupplier nanoClock) {
        this.nanoClock = nanoClock;
        return this;
    }

    /**
     * Builds the simulator, lets clients in and time go on.
     *
     * @throws TransportException if a transport cannot be opened
     * @throws IllegalArgumentException if the rate is not positive, or no processor has the name of
     *     that which overrides the others
     */
    public Simulator start() {
        MessageCatalogue messages = messages();
        Mailbox mailbox = new Mailbox(MAILBOX_CAPACITY);
        AuvsmlWriter writer = new AuvsmlWriter(messages);
        Clients clients = clients(messages, mailbox, writer, role, 1);
        Companions companions = new Companions(clients);
        logs.add(companions);
        SimulationLoop loop =
                new SimulationLoop(
                        settings(writer), mailbox, new Pace(rate, nanoClock), running, until);
        return new Simulator(world, loop, mailbox, clients, companions, transports).start();
    }

    /**
     * Builds a simulation that is given its inputs and makes its steps when it is told to. Those
     * who connect are viewers.
     *
     * @param during where a step that waits for feedback gets its inputs from
     * @throws TransportException if a transport cannot be opened
     * @throws IllegalArgumentException as {@link #start}
     */
    public SimulationReplay replay(InputSource during) {
        MessageCatalogue messages = messages();
        Mailbox mailbox = new Mailbox(MAILBOX_CAPACITY);
        SimulationSettings settings = settings(new AuvsmlWriter(messages));
        Clients viewers = clients(messages, mailbox, settings.writer(), Role.VIEWER, FIRST_VIEWER);
        return new SimulationReplay(
                        settings, during, mailbox, new Pace(rate, nanoClock), viewers, transports)
                .start();
    }

    private MessageCatalogue messages() {
        return catalogue.orElseGet(() -> MessageCatalogue.load(ContextClasses.loader()));
    }

    private SimulationSettings settings(AuvsmlWriter writer) {
        configureProcessors();
        return new SimulationSettings(
                world, timestepper, processors, horizon, released, writer, serverName, logs);
    }

    private Clients clients(
            MessageCatalogue messages,
            Mailbox mailbox,
            AuvsmlWriter writer,
            Role role,
            long firstId) {
        RootDecoder decoder = RootDecoder.strict(messages, limits);
        return new Clients(mailbox, decoder, writer, limits, role, firstId);
    }

    private void configureProcessors() {
        try {
            processors.configure(stated, override);
        } catch (RefusedException e) {
            throw new IllegalArgumentException(e.getMessage(), e);
        }
    }
}
