package org.auvsim.server.simulator;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.message.command.KeptSnapshot;
import org.auvsim.auvsml.message.command.RefusedException;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** States that a simulation can go back to, by name. */
final class Snapshots {
    /** So many are kept: each is a copy of the whole world. */
    private static final int MOST = 32;

    private final Map<String, SimulationState> byName = new LinkedHashMap<>();

    /**
     * Keeps one.
     *
     * @throws RefusedException if too many are kept
     */
    void keep(String name, SimulationState state) {
        if (byName.size() >= MOST && !byName.containsKey(name)) {
            throw new RefusedException(
                    ErrorCode.REFUSED,
                    "%d snapshots are kept, which is all that are; use one of their names again: %s"
                            .formatted(MOST, String.join(", ", byName.keySet())));
        }
        byName.put(name, state);
    }

    /**
     * The one of this name.
     *
     * @throws RefusedException if there is none
     */
    SimulationState named(String name) {
        SimulationState state = byName.get(name);
        if (state == null) {
            throw new RefusedException(
                    ErrorCode.UNKNOWN_ENTITY,
                    byName.isEmpty()
                            ? "there is no snapshot '%s': none was taken".formatted(name)
                            : "there is no snapshot '%s'; there are %s"
                                    .formatted(name, String.join(", ", byName.keySet())));
        }
        return state;
    }

    /** All, in the order in which they were first taken. */
    List<KeptSnapshot> list() {
        return byName.entrySet().stream()
                .map(kept -> new KeptSnapshot(kept.getKey(), kept.getValue().world().time()))
                .toList();
    }
}
