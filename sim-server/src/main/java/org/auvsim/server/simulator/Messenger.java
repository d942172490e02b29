package org.auvsim.server.simulator;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.session.ErrorResponse;

import java.util.List;
import java.util.Optional;

/** Brings messages of a companion to the simulation. For every thread but the simulation's. */
@FunctionalInterface
public interface Messenger {
    /**
     * Has messages carried out together, as those of an administrator, and waits until they are;
     * one that is refused keeps none of the others from being carried out.
     *
     * @return for each of them why it is refused; empty: it is carried out
     * @throws InterruptedException if the thread is interrupted, or the simulation has ended
     */
    List<Optional<ErrorResponse>> send(List<Message> messages) throws InterruptedException;
}
