package org.auvsim.server.simulator;

import org.auvsim.core.world.World;

/**
 * A step that is over.
 *
 * @param revision how often the past had been corrected before
 * @param step its number; the first is 1
 * @param world as it is now; to be read, and only until the call returns
 */
public record StepMade(int revision, long step, World world) {}
