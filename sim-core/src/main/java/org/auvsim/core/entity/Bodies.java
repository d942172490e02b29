package org.auvsim.core.entity;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The world objects of a world and the arrays that hold their numbers; object i has slot i. */
public final class Bodies {
    private final BodyState state;
    private final List<WorldObject> objects;
    private Optional<List<WorldObject>> active = Optional.empty();
    private int activeAt;

    /** No bodies. */
    public Bodies() {
        state = new BodyState();
        objects = new ArrayList<>();
    }

    private Bodies(Bodies original) {
        state = original.state.copy();
        objects = new ArrayList<>(original.objects.size());
        for (WorldObject object : original.objects) {
            objects.add(new WorldObject(object, state));
        }
    }

    /** An independent copy, equal bit for bit. */
    public Bodies copy() {
        return new Bodies(this);
    }

    /** The arrays. */
    public BodyState state() {
        return state;
    }

    /** The objects, by slot; a view. */
    public List<WorldObject> objects() {
        return Collections.unmodifiableList(objects);
    }

    /** What effects on them may know when they are laid out. */
    public Surroundings surroundings() {
        Map<Long, Integer> slots = new HashMap<>();
        objects.forEach(object -> slots.put(object.id(), object.slot()));
        return new Surroundings() {
            @Override
            public int slotOf(long bodyId) {
                return requireNonNull(slots.get(bodyId));
            }

            @Override
            public <F extends Field<?>> List<F> fields(Class<F> type) {
                return state.fields(type);
            }
        };
    }

    /** The objects that have behaviors, in order of id. */
    public List<WorldObject> active() {
        if (active.isEmpty() || activeAt != state.behaviorChanges()) {
            activeAt = state.behaviorChanges();
            active =
                    Optional.of(
                            objects.stream()
                                    .filter(object -> !object.behaviors().isEmpty())
                                    .sorted(Comparator.comparingLong(WorldObject::id))
                                    .toList());
        }
        return active.get();
    }

    /**
     * A number that is another one whenever a component that is no propulsor has come, changed or
     * gone, with its object or alone.
     */
    public int equipmentChanges() {
        return state.equipmentChanges();
    }

    /** Number of objects. */
    public int count() {
        return objects.size();
    }

    /**
     * Makes a live object of a definition.
     *
     * @throws IllegalArgumentException if a momentum is too large for a number; nothing has changed
     *     then
     */
    public WorldObject add(long id, WorldObjectDefinition definition) {
        try {
            WorldObject object = new WorldObject(id, definition, state);
            objects.add(object);
            active = Optional.empty();
            state.equipmentChanged();
            return object;
        } catch (IllegalArgumentException e) {
            state.remove(objects.size());
            throw e;
        }
    }

    /** Lets an effect act on an object; the effects are to be laid out again. */
    public void addEffect(WorldObject object, Effect effect) {
        object.addEffect(effect);
    }

    /** Ends an effect on an object, likewise; false if it has none that is equal. */
    public boolean removeEffect(WorldObject object, Effect effect) {
        return object.removeEffect(effect);
    }

    /** Removes an object; those behind it move down by one slot. */
    public void remove(WorldObject object) {
        int slot = object.slot();
        objects.remove(slot);
        active = Optional.empty();
        state.equipmentChanged();
        state.remove(slot);
        for (int i = slot; i < objects.size(); i++) {
            objects.get(i).moveToSlot(i);
        }
    }
}
