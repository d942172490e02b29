package org.auvsim.core.entity;

/**
 * What a wave brings to an object that it meets, told to the world's listeners ({@link
 * Change.Tell}): an immutable value.
 */
public interface Signal {}
