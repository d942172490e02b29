package org.auvsim.auvsml.message.lockstep;

/** A member that has not answered in time. */
public record LateMember(String name) {}
