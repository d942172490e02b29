package org.auvsim.server.simulator;

import org.auvsim.core.world.World;
import org.auvsim.server.feedback.AppliedFeedback;
import org.auvsim.server.feedback.PendingFeedback;

/**
 * Hears of all that decides the course of a simulation, in order and on the simulation thread,
 * which it must not hold up: a recording is made of it.
 */
public interface InputLog {
    /** The simulation is about to begin. */
    void begun(World world);

    /** An input is about to be taken. */
    void taken(InputPlace place, Input input);

    /** Feedback is used; what came of it, while its step is under way. Nothing depends on it. */
    default void corrected(World world, PendingFeedback feedback, AppliedFeedback applied) {
        // Inputs and steps decide.
    }

    /** A step was begun and could not be made; the world is as it was before. */
    void stepFailed(InputPlace place);

    /** A step is over, and what came of it is told. */
    void stepMade(StepMade step);
}
