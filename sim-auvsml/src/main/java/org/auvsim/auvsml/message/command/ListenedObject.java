package org.auvsim.auvsml.message.command;

import java.util.List;
import java.util.OptionalLong;

/**
 * A world object and the events of it that a client wants to hear.
 *
 * @param id the object's id, or {@code *} for all, present and future
 */
public record ListenedObject(String id, List<Listener> listener) {
    /** Stands for all world objects, present and future. */
    public static final String EVERY = "*";

    /**
     * A checked request.
     *
     * @throws IllegalArgumentException if the id is neither a positive whole number nor {@code *}
     */
    public ListenedObject {
        if (!id.equals(EVERY) && !id.matches("[1-9][0-9]{0,17}")) {
            throw new IllegalArgumentException(
                    "expected an id (1 or more) or '*' for all objects, but found '" + id + "'");
        }
    }

    /** The id; empty for all objects. */
    public OptionalLong worldObjectId() {
        return id.equals(EVERY) ? OptionalLong.empty() : OptionalLong.of(Long.parseLong(id));
    }
}
