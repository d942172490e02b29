package org.auvsim.auvsml.recording;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;

/**
 * A step was begun and could not be made, or was given up as the simulation ended.
 *
 * @param revision how often the past had been revised or left
 * @param step so many steps had been made
 * @param timestamp the world's time, as before
 */
public record StepFailed(@Default("0") int revision, long step, @Unit("s") double timestamp)
        implements Entry {}
