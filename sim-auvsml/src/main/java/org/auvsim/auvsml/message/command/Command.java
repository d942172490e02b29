package org.auvsim.auvsml.message.command;

import org.auvsim.auvsml.message.Message;

import java.util.Optional;

/**
 * A message with code (thesis, section 7.1.1): it is carried to the part of the system that it is
 * for and executed there. Its kind decides who may send it and when it runs.
 *
 * @param <P> the port to that part
 */
public sealed interface Command<P> extends Message
        permits ClientCommand, SimulatorCommand, WorldCommand, WorldObjectCommand {
    /**
     * Does what the command is for.
     *
     * @return the response to its sender, if it has one of its own
     * @throws RefusedException if it cannot be done; then nothing has changed
     */
    Optional<Message> execute(P port);
}
