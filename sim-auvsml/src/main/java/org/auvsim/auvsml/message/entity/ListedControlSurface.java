package org.auvsim.auvsml.message.entity;

/** A fin in a list. */
public record ListedControlSurface(String name) {}
