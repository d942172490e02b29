package org.auvsim.auvsml.recording;

import org.auvsim.auvsml.Role;
import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;

/**
 * A client came.
 *
 * @param revision how often the past had been revised or left
 * @param step so many steps had been made
 * @param index its place among the inputs since that step, from 0
 * @param duringStep whether it came while the next step waited for feedback
 * @param timestamp the world's time
 * @param sessionId the client's session
 * @param peer where it was
 * @param role what it might do
 */
public record ClientCame(
        @Default("0") int revision,
        long step,
        int index,
        @Default("0") boolean duringStep,
        @Unit("s") double timestamp,
        long sessionId,
        String peer,
        Role role)
        implements RecordedInput {}
