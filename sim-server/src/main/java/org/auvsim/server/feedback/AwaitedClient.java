package org.auvsim.server.feedback;

/** The name of a client whose feedback a step waits for. */
public record AwaitedClient(String name) {}
