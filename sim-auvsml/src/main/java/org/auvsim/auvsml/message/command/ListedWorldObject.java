package org.auvsim.auvsml.message.command;

/**
 * A world object in a list.
 *
 * @param type {@code WorldObject} for all of them (thesis, appendix A.4)
 */
public record ListedWorldObject(long id, String type, String name) {
    /** The type of every world object. */
    public static final String WORLD_OBJECT = "WorldObject";
}
