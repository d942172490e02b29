package org.auvsim.auvsml.message.lockstep;

import org.auvsim.auvsml.document.WhenLate;
import org.auvsim.auvsml.message.Message;

import java.util.List;

/**
 * Members have not answered a step in time; every client is told.
 *
 * @param step the step's number
 * @param then what is done about it
 * @param client those who have not answered, in order of their names
 */
public record LockstepTimeoutNotification(long step, WhenLate then, List<LateMember> client)
        implements Message {
    /** The list cannot be changed. */
    public LockstepTimeoutNotification {
        client = List.copyOf(client);
    }
}
