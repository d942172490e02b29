package org.auvsim.auvsml.message.command;

import org.auvsim.auvsml.document.FeedbackTimestepping;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.message.learning.ModelCorrection;

import java.util.Optional;
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

    /**
     * Makes steps in another way from the next one on.
     *
     * @throws RefusedException if the simulator has no such time-stepper
     */
    void setTimestepper(FeedbackTimestepping choice);

    /**
     * Lets one feedback processor do all corrections; empty: the one that each message names.
     *
     * @throws RefusedException if there is none of this name
     */
    void setFeedbackProcessor(Optional<String> name);

    /**
     * Keeps the world, and who controls what, as they are now; a snapshot of the same name is
     * replaced.
     *
     * @throws RefusedException if too many are kept
     */
    void takeSnapshot(String name);

    /**
     * Goes back to a snapshot. The world's time is then that of the snapshot; all clients are told.
     *
     * @throws RefusedException if there is none of this name
     */
    void restoreSnapshot(String name);

    /** Begins again, with the world of the scenario, or as it was when the simulation began. */
    void reset();

    /**
     * Goes on with another world, in the way that its scenario states; all clients are told.
     *
     * @throws RefusedException if the scenario's world cannot be had
     */
    void load(Scenario scenario);

    /** Tells those who listen what was found that the model of a world object lacks. */
    void announce(long worldObjectId, ModelCorrection correction);

    /**
     * Ends the session of a client, which is told the reason.
     *
     * @param client its session id or its name
     * @throws RefusedException if there is no such client
     */
    void disconnect(String client, String reason);
}
