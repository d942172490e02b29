package org.auvsim.auvsml.message.command;

/** What a {@link SimulatorQuery} can ask. */
public interface SimulatorView {
    /** How things stand. */
    SimulatorState state();
}
