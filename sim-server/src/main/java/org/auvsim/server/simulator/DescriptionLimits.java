package org.auvsim.server.simulator;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.framing.AuvsmlWriter;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.auvsml.message.entity.WorldObjectDescriptionResponse;
import org.auvsim.auvsml.xml.Limits;
import org.auvsim.auvsml.xml.XmlTreeReader;
import org.auvsim.core.entity.WorldObjectDefinition;

/** Keeps descriptions back that a client would refuse, found by writing and reading them. */
record DescriptionLimits(AuvsmlWriter writer) {
    /** The id of the request, which came in a message, is in the answer too. */
    private static final int MOST_BYTES = Limits.ANSWER.bytes() - Limits.MESSAGE.bytes();

    private static final XmlTreeReader CLIENT = new XmlTreeReader(Limits.ANSWER);

    /**
     * Nothing if a client can take the message with this description.
     *
     * @throws RefusedException saying what is too long for it
     */
    void requireReadable(WorldObjectDefinition definition) {
        byte[] message = writer.write(new WorldObjectDescriptionResponse(definition));
        if (message.length > MOST_BYTES) {
            throw refused(
                    definition,
                    "it has %d bytes, a message at most %d".formatted(message.length, MOST_BYTES));
        }
        try {
            CLIENT.read(message);
        } catch (AuvsmlException e) {
            throw refused(definition, e.fault().problem());
        }
    }

    private static RefusedException refused(WorldObjectDefinition definition, String why) {
        return new RefusedException(
                ErrorCode.REFUSED,
                "the description of '%s' is too long for a message (%s); its scenario has it"
                        .formatted(definition.name(), why));
    }
}
