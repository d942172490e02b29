package org.auvsim.auvsml.message.movement;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.description.Unit;

/**
 * The step that ends at this time is done: all its movements were sent (thesis, appendix A.3).
 *
 * @param stateType whether the world made the step or its projected copy
 */
public record TimestepAdvancedNotification(@Unit("s") double timestamp, StateType stateType)
        implements Message {}
