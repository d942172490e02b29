package org.auvsim.server.simulator;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.auvsim.core.world.WorldListener;
import org.auvsim.server.net.ClientSession;

import java.util.HashMap;
import java.util.Map;

/**
 * Which client holds which world object, the first that does something to it.
 *
 * <p>There are two of these: one for those who command, one for those who send feedback. So a pilot
 * and the robot that feels where it really is can share a vehicle.
 */
final class ControlledObjects implements WorldListener {
    private final World world;
    private final String verb;
    private final Map<Long, ClientSession> holders = new HashMap<>();

    /**
     * Nobody holds anything.
     *
     * @param verb what a holder does to the object, as "controls" or "corrects"
     */
    ControlledObjects(World world, String verb) {
        this.world = world;
        this.verb = verb;
    }

    /**
     * Gives an object to a client.
     *
     * @return false if it had it already
     * @throws RefusedException if there is no such object or another client holds it
     */
    boolean take(ClientSession client, long objectId) {
        WorldObject object = WorldPort.object(world, objectId);
        ClientSession holder = holders.putIfAbsent(objectId, client);
        if (holder != null && holder != client) {
            throw new RefusedException(
                    ErrorCode.NOT_IN_CONTROL,
                    "%s %s '%s' (id %d); wait until it lets go"
                            .formatted(holder, verb, object.name(), objectId));
        }
        return holder == null;
    }

    /**
     * Takes an object from a client.
     *
     * @return false if the client does not hold it
     * @throws RefusedException if there is no such object
     */
    boolean release(ClientSession client, long objectId) {
        WorldPort.object(world, objectId);
        return holders.remove(objectId, client);
    }

    /** Takes from a client all that it holds. */
    void releaseAll(ClientSession client) {
        holders.values().removeIf(holder -> holder == client);
    }

    @Override
    public void happened(WorldEvent event) {
        if (event instanceof WorldEvent.EntityRemoved removed) {
            holders.remove(removed.entityId());
        }
    }
}
