package org.auvsim.auvsml.message.feedback;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.description.Unit;

/**
 * Late feedback has corrected the past: the steps from then to now were made again. The present
 * states follow; what was told of the past is neither repeated nor taken back.
 *
 * @param revision how often that has happened
 * @param from the beginning of the first step that was made again
 * @param to now
 */
public record HistoryRevisedNotification(
        long revision, @Unit("s") double from, @Unit("s") double to) implements Message {}
