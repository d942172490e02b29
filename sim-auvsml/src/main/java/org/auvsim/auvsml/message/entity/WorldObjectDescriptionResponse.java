package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.entity.WorldObjectDefinition;

/**
 * A world object with its id, as a scenario would state it: what it was made from, with the motion,
 * forces, effects and components that it has now.
 */
public record WorldObjectDescriptionResponse(WorldObjectDefinition worldObject)
        implements Message {}
