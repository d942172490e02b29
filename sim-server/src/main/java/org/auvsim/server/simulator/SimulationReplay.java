package org.auvsim.server.simulator;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.framing.AuvsmlWriter;
import org.auvsim.auvsml.message.command.SimulatorState;
import org.auvsim.core.world.World;
import org.auvsim.server.net.ClientSession;
import org.auvsim.server.net.Transport;
import org.auvsim.server.net.TransportException;

import java.util.List;

/**
 * A simulation as a server runs it, but without a clock and clients: inputs and steps are given to
 * it. Viewers may listen, and ask, but change nothing. All its methods but one are for one thread.
 */
public final class SimulationReplay implements AutoCloseable {
    /** So many requests of viewers are carried out before time may go on. */
    private static final int MOST_REQUESTS = 256;

    private final Simulation simulation;
    private final Mailbox mailbox;
    private final Pace pace;
    private final Clients viewers;
    private final List<Transport> transports;
    private final AuvsmlWriter writer;

    SimulationReplay(
            SimulationSettings settings,
            InputSource during,
            Mailbox mailbox,
            Pace pace,
            Clients viewers,
            List<Transport> transports) {
        this.simulation =
                new Simulation(settings, during, new ReplayControl(this), /* nanoClock= */ () -> 0);
        this.mailbox = mailbox;
        this.pace = pace;
        this.viewers = viewers;
        this.transports = transports;
        this.writer = settings.writer();
    }

    /** Lets viewers in, who see time go on from now. */
    SimulationReplay start() {
        try {
            transports.forEach(transport -> transport.open(viewers));
        } catch (TransportException e) {
            close();
            throw e;
        }
        pace.start(world().time());
        return this;
    }

    /** The world, to be read between steps. */
    public World world() {
        return simulation.world();
    }

    /** Number of steps made. */
    public long steps() {
        return simulation.steps();
    }

    SimulatorState state() {
        return new SimulatorState(
                world().time(), /* running= */ true, pace.rate(), steps(), viewers.count());
    }

    void timeHasJumped() {
        pace.start(world().time());
    }

    /** A client that there once was: what is sent to it goes nowhere. */
    public ClientSession session(long id, String peer, Role role) {
        return ClientSession.ofThePast(id, peer, role, writer);
    }

    /** Takes an input. */
    public void take(Input input) {
        simulation.take(input);
    }

    /**
     * Makes a step.
     *
     * @throws RuntimeException if the world cannot make it, or what it waits for does not come
     */
    public void advanceTimestep() {
        simulation.advanceTimestep();
    }

    /** Answers viewers until the next step is due by the rate. */
    public void attend() {
        try {
            do {
                mailbox.take(MOST_REQUESTS, pace.nanosUntil(world().time())).forEach(this::take);
            } while (pace.nanosUntil(world().time()) > 0 && !mailbox.isClosed());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Lets {@link #attend} wait no longer; may be called by every thread. */
    public void stopAttending() {
        mailbox.close();
    }

    /** Ends the sessions of viewers. */
    @Override
    public void close() {
        mailbox.close();
        viewers.endAll("the replay has ended");
        transports.forEach(Transport::close);
    }
}
