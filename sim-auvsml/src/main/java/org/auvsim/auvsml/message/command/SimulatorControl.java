package org.auvsim.auvsml.message.command;

import java.util.OptionalDouble;

/** What a {@link SimulatorCommand} can do: how time goes on. */
public interface SimulatorControl extends SimulatorView {
    /** Stands still after the step that is under way; nothing happens if it does already. */
    void pause();

    /** Goes on; nothing happens if it does already. */
    void resume();

    /** Ends the simulation and all sessions. */
    void shutdown();

    /**
     * World seconds a second from now on.
     *
     * @param factor above 0; empty: as fast as possible
     */
    void setRate(OptionalDouble factor);

    /**
     * Makes so many steps while paused, as fast as possible, and stands still again.
     *
     * @throws RefusedException if the simulator is running
     */
    void step(int count);
}
