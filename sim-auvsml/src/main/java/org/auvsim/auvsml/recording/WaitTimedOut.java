package org.auvsim.auvsml.recording;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;

/**
 * A step had waited for feedback as long as it may.
 *
 * @param revision how often the past had been revised or left
 * @param step so many steps had been made
 * @param index its place among the inputs since that step, from 0
 * @param duringStep always so
 * @param timestamp the world's time
 */
public record WaitTimedOut(
        @Default("0") int revision,
        long step,
        int index,
        @Default("1") boolean duringStep,
        @Unit("s") double timestamp)
        implements RecordedInput {}
