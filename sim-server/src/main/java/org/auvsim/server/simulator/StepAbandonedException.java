package org.auvsim.server.simulator;

/** A step is not made: the simulation ends while it waits. */
final class StepAbandonedException extends RuntimeException {
    StepAbandonedException() {
        super("the simulation ends");
    }
}
