package org.auvsim.viz.source;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.ListedClient;
import org.auvsim.auvsml.message.control.SimulatorStateResponse;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;

/** A simulator as somebody at a viewer reaches it, from any thread. */
public interface Steering {
    /** What this viewer may do there; what a viewer may while there is no connection. */
    Role role();

    /** Whether there is a connection now. */
    boolean isConnected();

    /** How the simulator stood when it last told. */
    Optional<SimulatorStateResponse> state();

    /** Who was connected when it last told, and what each controls. */
    List<ListedClient> clients();

    /** The number of this viewer's session there. */
    long session();

    /**
     * Sends a message and hears what it brings: the response, or {@code CommandDoneResponse}.
     *
     * @return fails with a {@link RefusedException} whose message is a sentence for people, if the
     *     simulator refuses or there is no connection
     */
    CompletableFuture<Message> ask(Message message);

    /** What is done to this object is asked for each time that anything is. */
    void watch(OptionalLong id);
}
