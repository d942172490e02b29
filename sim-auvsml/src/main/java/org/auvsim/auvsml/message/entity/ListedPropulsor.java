package org.auvsim.auvsml.message.entity;

/** A propulsor in a list. */
public record ListedPropulsor(String name) {}
