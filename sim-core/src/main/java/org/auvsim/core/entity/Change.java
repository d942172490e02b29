package org.auvsim.core.entity;

import org.auvsim.core.math.Vec3;

import java.util.function.LongFunction;
import java.util.function.UnaryOperator;

/** One thing that a collision response wants changed in the world. */
public sealed interface Change {
    /**
     * Adds to the momenta of a body; nothing happens to a fixed body or one that has left.
     *
     * @param linear (kg m/s, world)
     * @param angular about the body's origin (kg m^2/s, world)
     */
    record Momentum(long objectId, Vec3 linear, Vec3 angular) implements Change {}

    /** Adds an entity that is no rigid body, made for the id that the world gives it. */
    record AddEntity(LongFunction<? extends Entity> made) implements Change {}

    /** Adds a world object. */
    record AddObject(WorldObjectDefinition definition) implements Change {}

    /**
     * Replaces an entity that is no rigid body by its changed self, of the same id and name. The
     * update gets the entity as it then is: of two responses at one instant none is lost. Nothing
     * happens if it has left.
     */
    record Update<E extends Entity>(long entityId, Class<E> type, UnaryOperator<E> update)
            implements Change {}

    /** Brings an object a signal, of which the world tells its listeners. */
    record Tell(long objectId, double time, Signal signal) implements Change {}

    /** Removes an entity; nothing happens if it has left already. */
    record Remove(long entityId) implements Change {}

    /**
     * Replaces the components of a type in an object by their changed selves; nothing happens if it
     * has none or has left.
     */
    record UpdateComponents<C extends Component>(
            long objectId, Class<C> type, UnaryOperator<C> update) implements Change {}
}
