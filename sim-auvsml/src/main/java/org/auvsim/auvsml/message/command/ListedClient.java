package org.auvsim.auvsml.message.command;

import org.auvsim.core.description.Default;

import java.util.List;

/**
 * A client in a list.
 *
 * @param sessionId its number, which no other session of the simulator has
 * @param name as it says it is, or one of the simulator's
 * @param peer where it is, as {@code 127.0.0.1:51234}
 * @param role what it may do
 * @param awaited whether the step that is under way waits for its answer
 * @param worldObject what it controls
 */
public record ListedClient(
        long sessionId,
        String name,
        String peer,
        String role,
        @Default("0") boolean awaited,
        List<ControlledObject> worldObject) {
    /** A world object that a client controls. */
    public record ControlledObject(long id) {}
}
