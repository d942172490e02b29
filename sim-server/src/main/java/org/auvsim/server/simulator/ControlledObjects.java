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

/** Which client controls which world object: one at most, the first that commands it. */
final class ControlledObjects implements WorldListener {
    private final World world;
    private final Map<Long, ClientSession> holders = new HashMap<>();

    ControlledObjects(World world) {
        this.world = world;
    }

    /**
     * Gives a client control of an object.
     *
     * @return false if it had it already
     * @throws RefusedException if there is no such object or another client controls it
     */
    boolean take(ClientSession client, long objectId) {
        WorldObject object = WorldPort.object(world, objectId);
        ClientSession holder = holders.putIfAbsent(objectId, client);
        if (holder != null && holder != client) {
            throw new RefusedException(
                    ErrorCode.NOT_IN_CONTROL,
                    "'%s' (id %d) is controlled by %s; wait until it lets go"
                            .formatted(object.name(), objectId, holder));
        }
        return holder == null;
    }

    /**
     * Takes control of an object from a client.
     *
     * @throws RefusedException if there is no such object or the client does not control it
     */
    void release(ClientSession client, long objectId) {
        WorldObject object = WorldPort.object(world, objectId);
        if (!holders.remove(objectId, client)) {
            throw new RefusedException(
                    ErrorCode.NOT_IN_CONTROL,
                    "%s does not control '%s' (id %d)"
                            .formatted(client.name(), object.name(), objectId));
        }
    }

    /** Takes from a client all that it controls. */
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
