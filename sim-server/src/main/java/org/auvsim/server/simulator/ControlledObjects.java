package org.auvsim.server.simulator;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.auvsim.core.world.WorldListener;
import org.auvsim.server.net.ClientSession;

import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Which client controls which world object: the first that commands it or corrects it. */
final class ControlledObjects implements WorldListener {
    private final World world;
    private final Map<Long, ClientSession> holders = new HashMap<>();

    /** Nobody controls anything. */
    ControlledObjects(World world) {
        this.world = world;
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
                    "%s controls '%s' (id %d); wait until it lets go"
                            .formatted(holder, object.name(), objectId));
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

    /** The ids of the objects that a client controls, in order. */
    List<Long> of(ClientSession client) {
        return holders.entrySet().stream()
                .filter(entry -> entry.getValue() == client)
                .map(Map.Entry::getKey)
                .sorted()
                .toList();
    }

    /** Who controls what now, by the object's id. */
    Map<Long, ClientSession> holders() {
        return Map.copyOf(holders);
    }

    /** Frees what is controlled by others than these. */
    void retain(Collection<ClientSession> clients) {
        holders.values().retainAll(clients);
    }

    /** Lets everything be controlled as it was before. */
    void restore(Map<Long, ClientSession> former) {
        holders.clear();
        holders.putAll(former);
    }

    @Override
    public void happened(WorldEvent event) {
        if (event instanceof WorldEvent.EntityRemoved removed) {
            holders.remove(removed.entityId());
        }
    }
}
