package org.auvsim.auvsml.message.movement;

/** Whether a step was made or only projected. */
public enum StateType {
    /** The world is there. */
    ACTUAL,
    /** The world would be there without feedback. */
    PROJECTED
}
