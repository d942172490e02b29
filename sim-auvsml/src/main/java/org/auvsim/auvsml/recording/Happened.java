package org.auvsim.auvsml.recording;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;

import java.util.List;

/**
 * What a step brought, or some of it: collisions, then movements in order of id. Step 0 is the
 * beginning, where all that can move has its state and its name told.
 *
 * @param revision how often the past had been revised or left
 * @param step so many steps had been made
 * @param timestamp the world's time
 * @param message as listeners hear it
 */
public record Happened(
        @Default("0") int revision, long step, @Unit("s") double timestamp, List<Message> message)
        implements Entry {
    /** The messages cannot be changed. */
    public Happened {
        message = List.copyOf(message);
    }
}
