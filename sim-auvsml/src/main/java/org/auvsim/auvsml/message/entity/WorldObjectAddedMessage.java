package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.description.Unit;
import org.auvsim.core.math.Vec3;

/**
 * A world object came into the world; follows its {@code entity-added-message} (thesis, appendix
 * A.2).
 */
public record WorldObjectAddedMessage(
        @Unit("s") double timestamp, long entityId, @Unit("m") Vec3 position) implements Message {}
