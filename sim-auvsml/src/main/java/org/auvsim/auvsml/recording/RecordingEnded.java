package org.auvsim.auvsml.recording;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;

/**
 * The recording ends here, as it was meant to; one without this entry was cut off.
 *
 * @param revision how often the past had been revised or left
 * @param step so many steps had been made
 * @param timestamp the world's time
 * @param reason why, in a sentence
 */
public record RecordingEnded(
        @Default("0") int revision, long step, @Unit("s") double timestamp, String reason)
        implements Entry {}
