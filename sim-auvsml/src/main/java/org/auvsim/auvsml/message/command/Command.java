package org.auvsim.auvsml.message.command;

import org.auvsim.auvsml.Role;
import org.auvsim.auvsml.message.Message;

import java.util.Optional;

/**
 * A message with code (thesis, section 7.1.1): it is carried to the part of the system that it is
 * for and executed there. Its kind decides who may send it and when it runs: what only asks runs at
 * any moment, also while a step waits for feedback; what changes something runs between two steps.
 *
 * @param <P> the port to that part
 */
public sealed interface Command<P> extends Message
        permits ClientCommand,
                SimulatorCommand,
                SimulatorQuery,
                WorldCommand,
                WorldObjectCommand,
                WorldQuery {
    /** The role that its sender must have at least. */
    Role role();

    /**
     * Whether it decides how the world goes on: then it runs between two steps, and in lock-step in
     * its turn. What does not, as a question, runs at any moment, also while a step waits.
     */
    boolean actsBetweenSteps();

    /**
     * Does what the command is for.
     *
     * @return the response to its sender, if it has one of its own
     * @throws RefusedException if it cannot be done; then nothing has changed
     */
    Optional<Message> execute(P port);
}
