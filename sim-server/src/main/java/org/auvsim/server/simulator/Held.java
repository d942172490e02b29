package org.auvsim.server.simulator;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.WorldObjectMessage;
import org.auvsim.server.net.ClientSession;

import java.util.Optional;

/** A message that waits for its turn. */
record Held(ClientSession session, Optional<String> requestId, Message message) {
    /** The world object that it is about; 0 for others. */
    long objectId() {
        return message instanceof WorldObjectMessage about ? about.worldObjectId() : 0;
    }
}
