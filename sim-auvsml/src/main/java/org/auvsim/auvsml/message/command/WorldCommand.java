package org.auvsim.auvsml.message.command;

/** A question to the world, or a change of what is in it. */
public non-sealed interface WorldCommand extends Command<WorldControl> {}
