package org.auvsim.auvsml.message.command;

import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Field;
import org.auvsim.core.entity.WorldObjectDefinition;

/** What a {@link WorldCommand} can do, between two steps: add to the world, take from it. */
public interface WorldControl extends WorldView {
    /**
     * Adds a field.
     *
     * @throws RefusedException if its id or name is taken
     */
    void add(Field<?> field);

    /**
     * Adds a world object.
     *
     * @return its id
     * @throws RefusedException if its id is taken
     */
    long add(WorldObjectDefinition definition);

    /**
     * Gives the world object of a definition's name what the definition states; its motion, the
     * forces on it and what its actuators are told stay.
     *
     * @throws RefusedException if there is no such object
     */
    void revise(WorldObjectDefinition definition);

    /**
     * Takes an entity out of the world.
     *
     * @throws RefusedException if there is no such entity
     */
    void remove(long entityId);

    /**
     * Lets an effect act on a world object from now on.
     *
     * @throws RefusedException if there is no such object, or the effect couples it to one that is
     *     not in the world
     */
    void addEffect(long worldObjectId, Effect effect);

    /**
     * Ends an effect on a world object; of equal ones the first.
     *
     * @throws RefusedException if there is no such object or it has no effect that is equal
     */
    void removeEffect(long worldObjectId, Effect effect);
}
