package org.auvsim.server.simulator;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.document.ReleasedObject;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.auvsim.core.world.WorldListener;
import org.auvsim.server.net.ClientSession;

import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Which client controls which world object: the first that commands it or corrects it. */
final class ControlledObjects implements WorldListener {
    private final World world;
    private final Map<Long, ClientSession> holders = new HashMap<>();
    private final History history;
    private ReleaseRule rule;

    /**
     * Nobody controls anything.
     *
     * @param history is told what letting go and taking does to the world
     * @param released what becomes of objects that clients let go
     */
    ControlledObjects(World world, History history, ReleasedObject released) {
        this.world = world;
        this.history = history;
        this.rule = new ReleaseRule(released);
    }

    /** Sets what becomes of objects that clients let go from now on. */
    void setReleased(ReleasedObject released) {
        rule = new ReleaseRule(released);
    }

    /**
     * Gives an object to a client; nothing happens if it has it already.
     *
     * @throws RefusedException if there is no such object or another client holds it
     */
    void take(ClientSession client, long objectId) {
        requireFree(client, objectId);
        if (holders.putIfAbsent(objectId, client) == null) {
            ReleaseRule now = rule;
            perform(
                    client,
                    "taking control",
                    () -> now.takeUp(world, WorldPort.object(world, objectId)));
        }
    }

    /**
     * Nothing if a client holds an object or could take it.
     *
     * @throws RefusedException if there is no such object or another client holds it
     */
    void requireFree(ClientSession client, long objectId) {
        WorldObject object = WorldPort.object(world, objectId);
        ClientSession holder = holders.getOrDefault(objectId, client);
        if (holder != client) {
            throw new RefusedException(
                    ErrorCode.NOT_IN_CONTROL,
                    "%s controls '%s' (id %d); wait until it lets go"
                            .formatted(holder, object.name(), objectId));
        }
    }

    /**
     * Takes an object from a client.
     *
     * @return false if the client does not hold it
     * @throws RefusedException if there is no such object
     */
    boolean release(ClientSession client, long objectId) {
        WorldPort.object(world, objectId);
        boolean isReleased = holders.remove(objectId, client);
        if (isReleased) {
            ReleaseRule now = rule;
            perform(
                    client,
                    "letting go",
                    () -> now.letGo(world, WorldPort.object(world, objectId)));
        }
        return isReleased;
    }

    /** Does something to the world that belongs to its past from now on; who controls does not. */
    private void perform(ClientSession client, String name, Runnable action) {
        action.run();
        history.add(new Deed(client, name, action));
    }

    /** Takes from a client all that it holds. */
    void releaseAll(ClientSession client) {
        of(client).forEach(id -> release(client, id));
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
        Set<ClientSession> others = new LinkedHashSet<>(holders.values());
        others.removeAll(clients);
        others.stream()
                .sorted(Comparator.comparingLong(ClientSession::id))
                .forEach(this::releaseAll);
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
