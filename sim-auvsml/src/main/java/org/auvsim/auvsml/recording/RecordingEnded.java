package org.auvsim.auvsml.recording;

import org.auvsim.core.description.Unit;

/**
 * The recording ends here, as it was meant to; one without this entry was cut off.
 *
 * @param step so many steps had been made
 * @param timestamp the world's time
 * @param reason why, in a sentence
 */
public record RecordingEnded(long step, @Unit("s") double timestamp, String reason)
        implements Entry {}
