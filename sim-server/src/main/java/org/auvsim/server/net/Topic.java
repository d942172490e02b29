package org.auvsim.server.net;

import org.auvsim.auvsml.message.command.EventType;

/**
 * What a message of state is about: of two on one topic, the newer one says it all.
 *
 * @param about the entity's id; {@link #NOBODY} for what belongs to no entity
 */
record Topic(EventType type, long about) {
    /** Stands for no entity; ids begin at 1. */
    static final long NOBODY = 0;
}
