package org.auvsim.viz.window;

import org.auvsim.auvsml.message.command.ListedClient;
import org.auvsim.viz.source.Steering;

import java.util.Optional;

/**
 * Who controls an object.
 *
 * @param isUs whether that is this viewer
 * @param name of the client
 */
record Holder(boolean isUs, String name) {
    /** Whoever a simulator last told of; empty if it is nobody. */
    static Optional<Holder> of(long object, Steering simulator) {
        return simulator.clients().stream()
                .filter(client -> holds(client, object))
                .findFirst()
                .map(c -> new Holder(c.sessionId() == simulator.session(), c.name()));
    }

    private static boolean holds(ListedClient client, long object) {
        return client.worldObject().stream().anyMatch(held -> held.id() == object);
    }

    /** As a sentence. */
    String words() {
        return (isUs ? "This viewer" : name) + " controls it.";
    }
}
