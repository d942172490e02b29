package org.auvsim.viz.scene;

import org.auvsim.core.entity.WorldObjectDefinition;

import java.util.Optional;

/**
 * A world object that a scene shows.
 *
 * @param definition what it is made of; empty while it is not known, and for good if the viewer
 *     does not know a volume, an effect or a component of it
 */
public record SeenObject(long id, String name, Optional<WorldObjectDefinition> definition) {
    /** An object and what it is made of. */
    public static SeenObject of(long id, WorldObjectDefinition definition) {
        return new SeenObject(id, definition.name(), Optional.of(definition));
    }

    /** Whether it has the same name and volume as another one. */
    boolean looksLike(SeenObject other) {
        return name.equals(other.name)
                && definition
                        .map(WorldObjectDefinition::volume)
                        .equals(other.definition.map(WorldObjectDefinition::volume));
    }

    /** Whether it never moves; also said of nothing that is not known. */
    public boolean isFixed() {
        return definition.isPresent() && definition.get().fixed();
    }
}
