package org.auvsim.auvsml.message.entity;

import org.auvsim.auvsml.message.Message;
import org.auvsim.core.description.Unit;

/** An entity came into the world (thesis, appendix A.2). */
public record EntityAddedMessage(@Unit("s") double timestamp, long entityId) implements Message {}
