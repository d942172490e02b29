package org.auvsim.auvsml.message.command;

import java.util.List;

/** What a {@link SimulatorQuery} can ask. */
public interface SimulatorView {
    /** How things stand. */
    SimulatorState state();

    /** The snapshots that are kept, in the order in which they were taken. */
    List<KeptSnapshot> snapshots();

    /** The clients that are connected, in the order in which they came. */
    List<ListedClient> clients();
}
