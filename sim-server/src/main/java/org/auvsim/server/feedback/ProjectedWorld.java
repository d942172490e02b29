package org.auvsim.server.feedback;

import org.auvsim.core.entity.MovementState;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.world.World;

import java.util.Collections;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * Where a step will end if nobody corrects it: the state that a copy of the world was left in (W_P
 * in the thesis, section 7.2). Events of the copy go nowhere.
 */
public final class ProjectedWorld {
    private final double time;
    private final World copy;
    private final Map<Long, MovementState> states = new TreeMap<>();

    private ProjectedWorld(World copy) {
        this.copy = copy;
        time = copy.time();
        for (WorldObject object : copy.objects()) {
            if (!object.isFixed()) {
                states.put(object.id(), object.movementState());
            }
        }
    }

    /** Projects a step of at most {@code wanted} (s); the world is left untouched. */
    static ProjectedWorld of(World world, double wanted) {
        World copy = world.copy();
        copy.advanceTimestep(wanted);
        return new ProjectedWorld(copy);
    }

    /** World time (s) at which the step will end. */
    public double time() {
        return time;
    }

    /** The states of all objects that can move, by id, in order. */
    public Map<Long, MovementState> states() {
        return Collections.unmodifiableMap(states);
    }

    /** How an object will move then; empty if it will have left the world. */
    Optional<RigidMotion> motion(long objectId) {
        return copy.find(objectId).map(_ -> RigidMotion.of(copy.object(objectId)));
    }
}
