package org.auvsim.server.simulator;

import org.auvsim.core.world.World;
import org.auvsim.server.feedback.FeedbackProcessor;

/**
 * A feedback processor that has a {@link Companion} for each world object that it corrects. What
 * the companion has to say to the simulation it sends as a client does: so a recording has it, and
 * a replay, which has no companions, repeats it bit for bit.
 */
public interface AccompaniedProcessor extends FeedbackProcessor {
    /**
     * A companion, from the first correction of an object on.
     *
     * @param world as it is then; only to be read, and only now
     * @param toSimulator takes what the companion wants there
     */
    Companion companion(World world, long objectId, Messenger toSimulator);
}
