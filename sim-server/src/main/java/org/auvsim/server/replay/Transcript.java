package org.auvsim.server.replay;

import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.command.ListedWorldObject;
import org.auvsim.auvsml.message.entity.EntityRemovedMessage;
import org.auvsim.auvsml.message.entity.WorldObjectListResponse;
import org.auvsim.auvsml.message.movement.CollisionNotification;
import org.auvsim.auvsml.message.movement.MovementStateChangeMessage;
import org.auvsim.auvsml.recording.Entry;
import org.auvsim.auvsml.recording.Happened;
import org.auvsim.auvsml.recording.StateHash;
import org.auvsim.core.entity.MovementState;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.auvsim.core.world.WorldListener;
import org.auvsim.server.simulator.StepMade;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/**
 * What a recording tells of a world's course: who is in it, collisions, departures, movements, and
 * hashes. The same course has the same transcript, whether it is recorded or replayed. Belongs to
 * the simulation thread.
 */
final class Transcript implements WorldListener {
    /** So many messages stand in an entry, so that none is too long to be read at once. */
    private static final int MOST_MESSAGES = 64;

    private final int hashEvery;
    private final Consumer<Entry> to;
    private final List<Message> news = new ArrayList<>();
    private final Map<Long, String> listed = new HashMap<>();
    private final Map<Long, MovementState> last = new HashMap<>();

    /** Gives its entries {@code to} somebody, with a hash after so many steps each. */
    Transcript(int hashEvery, Consumer<Entry> to) {
        this.hashEvery = hashEvery;
        this.to = to;
    }

    /**
     * Tells of a world as it is before its first step, and hears from now on what happens in it.
     */
    void begin(World world) {
        tell(0, 0, world);
        world.addListener(this);
    }

    @Override
    public void happened(WorldEvent event) {
        switch (event) {
            case WorldEvent.Collided collided ->
                    news.add(CollisionNotification.of(collided.time(), collided.collision()));
            case WorldEvent.EntityRemoved removed -> {
                listed.remove(removed.entityId());
                last.remove(removed.entityId());
                news.add(new EntityRemovedMessage(removed.time(), removed.entityId()));
            }
            default -> {
                // movements are told as they are after the whole step, feedback included
            }
        }
    }

    /** Tells of a step. */
    void stepMade(StepMade step) {
        tell(step.revision(), step.step(), step.world());
    }

    private void tell(int revision, long step, World world) {
        double time = world.time();
        addNewObjects(world);
        addMovements(world);
        for (int from = 0; from < news.size(); from += MOST_MESSAGES) {
            int end = Math.min(news.size(), from + MOST_MESSAGES);
            to.accept(new Happened(revision, step, time, news.subList(from, end)));
        }
        news.clear();
        if (step % hashEvery == 0) {
            to.accept(StateHash.of(revision, step, time, world.stateHash()));
        }
    }

    private void addNewObjects(World world) {
        List<ListedWorldObject> added = new ArrayList<>();
        for (WorldObject object : world.objects()) {
            if (!object.name().equals(listed.put(object.id(), object.name()))) {
                added.add(
                        new ListedWorldObject(
                                object.id(), ListedWorldObject.WORLD_OBJECT, object.name()));
            }
        }
        if (!added.isEmpty()) {
            news.add(new WorldObjectListResponse(added));
        }
    }

    private void addMovements(World world) {
        for (WorldObject object : world.objects()) {
            MovementState state = object.movementState();
            if (!object.isFixed() && !state.equals(last.put(object.id(), state))) {
                news.add(MovementStateChangeMessage.of(world.time(), object.id(), false, state));
            }
        }
    }
}
