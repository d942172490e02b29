package org.auvsim.auvsml.message.control;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.description.Unit;

/**
 * The world has gone back to a snapshot, to its beginning, or on to another scenario; every client
 * is told. Which entities have come and gone by that, and the present states, follow.
 *
 * @param revision how often the past has been corrected or left
 * @param timestamp the world's time now
 * @param name the snapshot's; {@code *BEGINNING*} after a reset, {@code *SCENARIO*} after another
 *     scenario was loaded
 */
public record SnapshotRestoredNotification(long revision, @Unit("s") double timestamp, String name)
        implements Message {}
