package org.auvsim.auvsml.message.radio;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.WorldObjectCommand;
import org.auvsim.auvsml.message.command.WorldObjectControl;
import org.auvsim.core.communication.Radio;

import java.util.Optional;

/**
 * Sends a message by a radio of a world object; whom it reaches, a {@link RadioMessage} tells.
 *
 * @param radio its name
 */
public record SendRadioMessageCommand(long worldObjectId, String radio, String text)
        implements WorldObjectCommand {
    @Override
    public Optional<Message> execute(WorldObjectControl object) {
        object.transmit(Radio.class, radio, text);
        return Optional.empty();
    }
}
