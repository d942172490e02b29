package org.auvsim.server.simulator;

import org.auvsim.auvsml.framing.AuvsmlWriter;
import org.auvsim.core.world.World;
import org.auvsim.server.feedback.FeedbackProcessors;
import org.auvsim.server.feedback.FeedbackTimestepper;

import java.util.List;

/**
 * What a simulation is made of.
 *
 * @param world belongs to the simulation from now on
 * @param horizon how far back (s) late feedback may correct the past
 * @param serverName what the welcome message says of the server
 */
record SimulationSettings(
        World world,
        FeedbackTimestepper timestepper,
        FeedbackProcessors processors,
        double horizon,
        AuvsmlWriter writer,
        String serverName,
        List<InputLog> logs) {
    SimulationSettings {
        logs = List.copyOf(logs);
    }
}
