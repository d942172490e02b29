package org.auvsim.server.simulator;

import org.auvsim.core.world.World;
import org.auvsim.server.feedback.PendingFeedback;
import org.auvsim.server.feedback.ProcessorMemory;
import org.auvsim.server.net.ClientSession;

import java.util.List;
import java.util.Map;

/**
 * All that a simulation goes on from, as it was between two steps.
 *
 * @param world a copy, never touched
 * @param holders who controls which world object, by its id
 * @param pending feedback that waits for its step
 * @param memory what feedback processors remember; a copy
 */
record SimulationState(
        World world,
        Map<Long, ClientSession> holders,
        List<PendingFeedback> pending,
        ProcessorMemory memory) {}
