package org.auvsim.core.step;

/** Two collidables by their numbers in a {@link Motion}, the lower one first. */
record Pair(int first, int second) {}
