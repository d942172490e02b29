package org.auvsim.auvsml.message.session;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.OneLine;
import org.auvsim.auvsml.message.command.SimulatorCommand;
import org.auvsim.auvsml.message.command.SimulatorControl;
import org.auvsim.core.description.Default;

import java.util.Optional;

/**
 * Ends the session of a client, which is told the reason; what it controls is free again.
 *
 * @param client its session id or its name
 * @param reason for the client
 */
public record DisconnectClientCommand(
        String client, @Default("an administrator has ended the session") String reason)
        implements SimulatorCommand {
    /**
     * A checked command.
     *
     * @throws IllegalArgumentException if the client or the reason is not one line
     */
    public DisconnectClientCommand {
        OneLine.of("a client's name", client);
        OneLine.of("the reason", reason);
    }

    @Override
    public Optional<Message> execute(SimulatorControl simulator) {
        simulator.disconnect(client, reason);
        return Optional.empty();
    }
}
