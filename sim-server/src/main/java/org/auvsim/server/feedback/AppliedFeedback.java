package org.auvsim.server.feedback;

import java.util.List;

/**
 * A correction that was made.
 *
 * @param time of the world (s)
 * @param processor the name of the processor
 * @param errorBefore distance of the object from where it ought to be, without the correction (m)
 * @param errorAfter the same distance with it (m)
 * @param overlaps ids of what the object shares space with now
 */
public record AppliedFeedback(
        long objectId,
        double time,
        String processor,
        double errorBefore,
        double errorAfter,
        List<Long> overlaps) {}
