package org.auvsim.server.simulator;

import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.auvsml.message.command.SimulatorState;

import java.util.OptionalDouble;

/** How time goes on: what a clock does with a simulation, which has none itself. */
interface TimeControl {
    /** Stands still after the step that is under way. */
    void pause();

    /** Goes on. */
    void resume();

    /** Ends the simulation. */
    void shutdown();

    /** World seconds a second from now on; empty: as fast as possible. */
    void setRate(OptionalDouble factor);

    /**
     * Makes so many steps while paused.
     *
     * @throws RefusedException if it is running
     */
    void step(int count);

    /** How things stand. */
    SimulatorState state();

    /**
     * The world's time has jumped: what is due when has to be found anew, and steps that were asked
     * for from where it was are not made.
     */
    void timeHasJumped();
}
