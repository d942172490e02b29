package org.auvsim.auvsml.recording;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;

import java.util.Optional;

/**
 * A root element, or other text, that could not be read; nothing of it counted.
 *
 * @param revision how often the past had been revised or left
 * @param step so many steps had been made
 * @param index its place among the inputs since that step, from 0
 * @param duringStep whether it came while the next step waited for feedback
 * @param timestamp the world's time
 * @param sessionId the client's session
 * @param requestId the root's request-id, if that could be read
 * @param code the kind of the fault
 * @param problem what was wrong
 * @param path the way to the place from the root
 * @param line the place's line in all that the client had sent, from 1
 * @param column the place's column, from 1
 */
public record ClientSentUnreadable(
        @Default("0") int revision,
        long step,
        int index,
        @Default("0") boolean duringStep,
        @Unit("s") double timestamp,
        long sessionId,
        Optional<String> requestId,
        ErrorCode code,
        String problem,
        String path,
        int line,
        int column)
        implements RecordedInput {}
