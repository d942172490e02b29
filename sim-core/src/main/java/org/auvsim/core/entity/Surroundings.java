package org.auvsim.core.entity;

import java.util.List;

/** What effects may know of the world when they are laid out over its bodies. */
public interface Surroundings {
    /** The slot of the body with an id. */
    int slotOf(long bodyId);

    /** The fields of a type, in order of id; {@link Current}s are in each {@link Block} already. */
    <F extends Field<?>> List<F> fields(Class<F> type);
}
