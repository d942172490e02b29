package org.auvsim.server.simulator;

import org.auvsim.core.world.World;
import org.auvsim.server.feedback.AppliedFeedback;
import org.auvsim.server.feedback.PendingFeedback;

import java.util.Map;
import java.util.TreeMap;

/** The companions of a running simulation. Belongs to the simulation thread. */
final class Companions implements InputLog {
    private final Clients clients;
    private final Map<String, Companion> companions = new TreeMap<>();

    Companions(Clients clients) {
        this.clients = clients;
    }

    @Override
    public void begun(World world) {
        // They come with the first corrections.
    }

    @Override
    public void taken(InputPlace place, Input input) {
        // What comes of it shows in the steps.
    }

    @Override
    public void stepFailed(InputPlace place) {
        // The world is as it was.
    }

    @Override
    public void corrected(World world, PendingFeedback feedback, AppliedFeedback applied) {
        if (feedback.processor() instanceof AccompaniedProcessor processor) {
            companions
                    .computeIfAbsent(
                            applied.objectId() + " " + processor.name(),
                            _ -> companion(processor, world, applied.objectId()))
                    .corrected(feedback.message(), applied);
        }
    }

    private Companion companion(AccompaniedProcessor processor, World world, long objectId) {
        InsideClient client = clients.inside();
        Companion companion = processor.companion(world, objectId, client);
        client.tellRefusals(companion::refused);
        return companion;
    }

    @Override
    public void stepMade(StepMade step) {
        companions.values().forEach(companion -> companion.stepMade(step));
    }

    /** They hear of nothing any more. */
    void close() {
        companions.values().forEach(Companion::close);
    }
}
