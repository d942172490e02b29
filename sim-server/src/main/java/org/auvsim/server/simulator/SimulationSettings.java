package org.auvsim.server.simulator;

import org.auvsim.auvsml.document.ReleasedObject;
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
 * @param released what becomes of objects that clients let go
 * @param serverName what the welcome message says of the server
 */
record SimulationSettings(
        World world,
        FeedbackTimestepper timestepper,
        FeedbackProcessors processors,
        double horizon,
        ReleasedObject released,
        AuvsmlWriter writer,
        String serverName,
        List<InputLog> logs) {
    SimulationSettings {
        logs = List.copyOf(logs);
    }
}
