package org.auvsim.auvsml.message.radio;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldObjectCommand;
import org.auvsim.auvsml.message.command.WorldObjectControl;
import org.auvsim.core.communication.AcousticModem;

import java.util.Optional;

/**
 * Sends a message by an acoustic modem of a world object; whom it reaches, a {@link RadioMessage}
 * tells.
 *
 * @param modem its name
 */
public record SendAcousticMessageCommand(long worldObjectId, String modem, String text)
        implements WorldObjectCommand {
    @Override
    public Optional<Message> execute(WorldObjectControl object) {
        object.transmit(AcousticModem.class, modem, text);
        return Optional.empty();
    }
}
