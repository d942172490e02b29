package org.auvsim.server.simulator;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.SimulatorState;
import org.auvsim.core.step.Lanes;
import org.auvsim.core.world.World;
import org.auvsim.server.net.Transport;
import org.auvsim.server.net.TransportException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

import java.util.List;
import java.util.OptionalDouble;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;

/**
 * A running simulation: a world, and the clients that hear of it, command it and correct it.
 *
 * <p>Its methods may be called from every thread but those of listeners inside the world.
 */
public final class Simulator implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(Simulator.class);

    private final World world;
    private final SimulationLoop loop;
    private final Mailbox mailbox;
    private final Clients clients;
    private final Companions companions;
    private final List<Transport> transports;
    private final Thread thread = new Thread(this::run, "simulation");
    private final CompletableFuture<Void> ended = new CompletableFuture<>();

    Simulator(
            World world,
            SimulationLoop loop,
            Mailbox mailbox,
            Clients clients,
            Companions companions,
            List<Transport> transports) {
        this.world = world;
        this.loop = loop;
        this.mailbox = mailbox;
        this.clients = clients;
        this.companions = companions;
        this.transports = transports;
    }

    /** Starts to build a simulator of a world, which belongs to the simulator from its start on. */
    public static SimulatorBuilder of(World world) {
        return new SimulatorBuilder(world);
    }

    /**
     * Starts to build a simulator of a scenario's world, with the feedback it asks for.
     *
     * @throws org.auvsim.core.world.WorldException if an id or a name is used twice
     * @throws IllegalArgumentException if its feedback time-stepper is none of a server
     */
    public static SimulatorBuilder of(Scenario scenario) {
        return of(scenario, Lanes.ONE);
    }

    /** The same, its steps made on these lanes, which stay the caller's to close afterwards. */
    public static SimulatorBuilder of(Scenario scenario, Lanes lanes) {
        return ScenarioSettings.builder(scenario, lanes);
    }

    /**
     * Lets clients in and time go on.
     *
     * @throws TransportException if a transport cannot be opened; then nothing has started
     */
    Simulator start() {
        try {
            transports.forEach(transport -> transport.open(clients));
        } catch (TransportException e) {
            mailbox.close();
            transports.forEach(Transport::close);
            throw e;
        }
        thread.start();
        return this;
    }

    private void run() {
        try {
            loop.run();
        } catch (InterruptedException e) {
            LOG.info("the simulation was interrupted");
        } finally {
            mailbox.close();
            companions.close();
            clients.endAll("the simulation has ended");
            transports.forEach(Transport::close);
            ended.complete(null);
        }
    }

    /** Waits until the simulation has ended: by {@link #close}, by a command, or at its time. */
    public void await() {
        ended.join();
    }

    /** Ends the simulation and all sessions, and waits until that is done. */
    @Override
    public void close() {
        mailbox.close();
        ended.join();
    }

    /**
     * Has a question to the world answered, or the world changed, between two steps, by the thread
     * that owns it; after the end, by the calling thread. Views on the world must not leave it.
     */
    public <T> T ask(Function<World, T> question) {
        return onSimulationThread(() -> question.apply(world));
    }

    /** Tells all clients, soon. */
    public void tell(Message message) {
        try {
            mailbox.post(new Input.Asked(() -> loop.tell(message)));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private <T> T onSimulationThread(Supplier<T> question) {
        CompletableFuture<T> answer = new CompletableFuture<>();
        try {
            mailbox.post(new Input.Asked(() -> answer.completeAsync(question, Runnable::run)));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted before the simulator could answer", e);
        }
        CompletableFuture.anyOf(answer, ended).handle((_, _) -> true).join();
        return answer.isDone() ? outcome(answer) : question.get();
    }

    private static <T> T outcome(CompletableFuture<T> answer) {
        try {
            return answer.join();
        } catch (CompletionException e) {
            throw e.getCause() instanceof RuntimeException cause ? cause : e;
        }
    }

    private void control(Consumer<SimulationLoop> command) {
        onSimulationThread(
                () -> {
                    command.accept(loop);
                    return true;
                });
    }

    /** How things stand. */
    public SimulatorState state() {
        return onSimulationThread(loop::state);
    }

    /** Stands still after the step that is under way. */
    public void pause() {
        control(SimulationLoop::pause);
    }

    /** Goes on. */
    public void resume() {
        control(SimulationLoop::resume);
    }

    /**
     * Makes one step while the simulation is paused (thesis, section 7.2), with feedback as its
     * time-stepper has it.
     *
     * @throws org.auvsim.auvsml.message.command.RefusedException if the simulation is running
     */
    public void advanceTimestep() {
        control(SimulationLoop::stepNow);
    }

    /** World seconds a second from now on; empty: as fast as possible. */
    public void setRate(OptionalDouble rate) {
        control(c -> c.setRate(rate));
    }
}
