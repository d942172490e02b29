package org.auvsim.server.simulator;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.message.command.EventType;
import org.auvsim.auvsml.message.command.ListenedObject;
import org.auvsim.auvsml.message.command.Listener;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.auvsml.message.command.SessionControl;
import org.auvsim.core.world.World;
import org.auvsim.server.net.ClientSession;

import java.util.List;
import java.util.function.LongConsumer;
import java.util.function.ToLongFunction;

/** One client's session as commands reach it. */
record SessionPort(
        ClientSession session,
        World world,
        ControlledObjects controlled,
        ToLongFunction<String> join,
        LongConsumer ready,
        Runnable end)
        implements SessionControl {
    @Override
    public void register(List<ListenedObject> objects) {
        for (ListenedObject object : objects) {
            object.worldObjectId().ifPresent(this::requireEntity);
            requireEventTypes(object);
        }
        objects.forEach(session::register);
    }

    @Override
    public void unregister(List<ListenedObject> objects) {
        for (ListenedObject object : objects) {
            object.worldObjectId().stream()
                    .filter(id -> !session.isRegisteredFor(id)) // it may have left the world
                    .forEach(this::requireEntity);
            requireEventTypes(object);
        }
        objects.forEach(session::unregister);
    }

    private void requireEntity(long id) {
        if (world.find(id).isEmpty()) {
            throw new RefusedException(
                    ErrorCode.UNKNOWN_ENTITY,
                    "no entity has the id %d; nothing of this request was done".formatted(id));
        }
    }

    private static void requireEventTypes(ListenedObject object) {
        for (Listener listener : object.listener()) {
            if (!EventType.names().contains(listener.type())) {
                throw new RefusedException(
                        ErrorCode.INVALID_VALUE,
                        "no event type has the name '%s'; there are %s; nothing of this request was done"
                                .formatted(listener.type(), EventType.names()));
            }
        }
    }

    @Override
    public void takeControl(long worldObjectId) {
        controlled.take(session, worldObjectId);
    }

    @Override
    public void releaseControl(long worldObjectId) {
        if (!controlled.release(session, worldObjectId)) {
            throw new RefusedException(
                    ErrorCode.NOT_IN_CONTROL,
                    "%s does not control '%s' (id %d)"
                            .formatted(
                                    session.name(),
                                    world.object(worldObjectId).name(),
                                    worldObjectId));
        }
    }

    @Override
    public long join(String name) {
        return join.applyAsLong(name);
    }

    @Override
    public void ready(long step) {
        ready.accept(step);
    }

    @Override
    public void disconnect() {
        end.run();
    }
}
