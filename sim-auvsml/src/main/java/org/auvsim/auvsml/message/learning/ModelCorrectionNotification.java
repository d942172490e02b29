package org.auvsim.auvsml.message.learning;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.description.Unit;

/** It was found out, while the simulation ran, what the model of a world object lacks. */
public record ModelCorrectionNotification(
        long worldObjectId, @Unit("s") double timestamp, ModelCorrection modelCorrection)
        implements Message {}
