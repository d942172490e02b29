package org.auvsim.core.world;

/** Hears of what happens in a world, on the thread that owns it, never in mid-step. */
public interface WorldListener {
    /** Called for each event, in order. */
    void happened(WorldEvent event);
}
