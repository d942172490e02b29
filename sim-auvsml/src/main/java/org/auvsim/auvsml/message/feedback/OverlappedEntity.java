package org.auvsim.auvsml.message.feedback;

/** An entity that a corrected object shares space with. */
public record OverlappedEntity(long entityId) {}
