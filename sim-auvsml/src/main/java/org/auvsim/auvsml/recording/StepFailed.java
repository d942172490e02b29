package org.auvsim.auvsml.recording;

import org.auvsim.core.description.Unit;

/**
 * A step was begun and could not be made, or was given up as the simulation ended.
 *
 * @param step so many steps had been made
 * @param timestamp the world's time, as before
 */
public record StepFailed(long step, @Unit("s") double timestamp) implements Entry {}
