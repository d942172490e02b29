package org.auvsim.core.world;

/** A request that a world cannot meet, or a state that it cannot leave; one clear sentence. */
public final class WorldException extends RuntimeException {
    private static final long serialVersionUID = 1;

    /** With one clear sentence. */
    public WorldException(String message) {
        super(message);
    }
}
