package org.auvsim.auvsml.xml;

/** A line and a column (in UTF-16 units) of a text, both from 1. */
public record Place(int line, int column) {}
