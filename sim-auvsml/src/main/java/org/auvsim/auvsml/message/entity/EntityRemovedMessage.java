package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.description.Unit;

/** An entity left the world; its id is not used again. */
public record EntityRemovedMessage(@Unit("s") double timestamp, long entityId) implements Message {}
