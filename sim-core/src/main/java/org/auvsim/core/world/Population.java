package org.auvsim.core.world;

import org.auvsim.core.entity.Bodies;
import org.auvsim.core.entity.CoupledEffect;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Entity;
import org.auvsim.core.entity.Field;
import org.auvsim.core.entity.RigidBody;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;

/** Who is in a world: entities by id and by name, both unique, ids never used again. */
final class Population {
    private final Bodies bodies;
    private final TreeMap<Long, Entity> byId;
    private final Map<String, Long> idsByName;
    private final Set<Long> left;
    private Optional<List<WorldObject>> objects = Optional.empty();
    private Optional<List<Entity>> others = Optional.empty();
    private long nextId;

    Population() {
        bodies = new Bodies();
        byId = new TreeMap<>();
        idsByName = new HashMap<>();
        left = new HashSet<>();
        nextId = 1;
    }

    /** An independent copy; entities that are no bodies are immutable and shared. */
    Population(Population original) {
        bodies = original.bodies.copy();
        byId = new TreeMap<>(original.byId);
        bodies.objects().forEach(object -> byId.put(object.id(), object));
        idsByName = new HashMap<>(original.idsByName);
        left = new HashSet<>(original.left);
        nextId = original.nextId;
    }

    Bodies bodies() {
        return bodies;
    }

    /** All entities in order of id; a view. */
    Collection<Entity> entities() {
        return Collections.unmodifiableCollection(byId.values());
    }

    /** All world objects in order of id. */
    List<WorldObject> objects() {
        if (objects.isEmpty()) {
            List<WorldObject> list = new ArrayList<>(bodies.objects());
            list.sort(Comparator.comparingLong(WorldObject::id));
            objects = Optional.of(List.copyOf(list));
        }
        return objects.get();
    }

    /** All entities that are no world objects, in order of id. */
    List<Entity> others() {
        if (others.isEmpty()) {
            others =
                    Optional.of(
                            byId.values().stream()
                                    .filter(entity -> !(entity instanceof WorldObject))
                                    .toList());
        }
        return others.get();
    }

    long nextId() {
        return nextId;
    }

    /** Ids below this one are not given any more. */
    void reserve(long id) {
        nextId = Math.max(nextId, id);
    }

    Optional<Entity> find(long id) {
        return Optional.ofNullable(byId.get(id));
    }

    Optional<WorldObject> findObject(long id) {
        return byId.get(id) instanceof WorldObject object ? Optional.of(object) : Optional.empty();
    }

    WorldObject object(long id) {
        return findObject(id).orElseThrow(() -> unknown("the id " + id));
    }

    WorldObject object(String name) {
        Long id = idsByName.get(name);
        return Optional.ofNullable(id)
                .flatMap(this::findObject)
                .orElseThrow(() -> unknown("the name '" + name + "'"));
    }

    WorldObject add(WorldObjectDefinition definition) {
        long id = definition.id().orElse(nextId);
        requireFree(id, definition.name());
        WorldObject object = bodies.add(id, definition);
        enter(object);
        return object;
    }

    /** Makes an object anew, under its id. */
    WorldObject remake(WorldObject former, WorldObjectDefinition definition) {
        WorldObject object = bodies.add(former.id(), definition);
        bodies.remove(former);
        byId.put(object.id(), object);
        objects = Optional.empty();
        return object;
    }

    void add(Entity entity) {
        if (entity instanceof RigidBody) {
            throw new WorldException(
                    "'%s' is a body of a world already; add its definition instead"
                            .formatted(entity.name()));
        }
        requireFree(entity.id(), entity.name());
        if (entity instanceof Current current) {
            requireReady(current);
        }
        enter(entity);
    }

    private static void requireReady(Current current) {
        try {
            current.prepared();
        } catch (IllegalArgumentException e) {
            throw new WorldException(String.valueOf(e.getMessage()));
        }
    }

    private void enter(Entity entity) {
        byId.put(entity.id(), entity);
        fieldsChanged(entity);
        idsByName.put(entity.name(), entity.id());
        nextId = Math.max(nextId, entity.id() + 1);
        objects = Optional.empty();
        others = Optional.empty();
    }

    private void requireFree(long id, String name) {
        if (id < 1) {
            throw new WorldException(
                    "the id of '%s' must be 1 or more, but is %d".formatted(name, id));
        }
        Entity holder = byId.get(id);
        if (holder != null) {
            throw new WorldException(
                    "the id %d of '%s' is taken by '%s'; ids are unique in a world"
                            .formatted(id, name, holder.name()));
        }
        if (left.contains(id)) {
            throw new WorldException(
                    "the id %d of '%s' was that of an entity that has left; ids are not used again"
                            .formatted(id, name));
        }
        Long namesake = idsByName.get(name);
        if (namesake != null) {
            throw new WorldException(
                    "the name '%s' is taken by entity %d; names are unique in a world"
                            .formatted(name, namesake));
        }
    }

    /** Each body that one of these effects couples the named one to has to be here, and another. */
    void requirePartners(String name, List<Effect> effects) {
        for (Effect effect : effects) {
            if (effect instanceof CoupledEffect coupled) {
                requirePartners(name, coupled);
            }
        }
    }

    private void requirePartners(String name, CoupledEffect effect) {
        String what = effect.getClass().getSimpleName() + " of '" + name + "'";
        List<Long> ids = effect.partners();
        if (ids.isEmpty() || Set.copyOf(ids).size() < ids.size()) {
            throw new WorldException(
                    "the %s has to name each of its partners once, but names %s"
                            .formatted(what, ids));
        }
        for (long id : ids) {
            Optional<WorldObject> partner = findObject(id);
            if (partner.isEmpty()) {
                throw new WorldException(
                        "the %s couples it to the id %d, which no world object has; there are %s"
                                .formatted(what, id, names()));
            }
            if (partner.get().name().equals(name)) {
                throw new WorldException(
                        "the %s couples it to itself (id %d); name another body"
                                .formatted(what, id));
            }
        }
    }

    void remove(long id) {
        Entity entity = byId.remove(id);
        if (entity == null) {
            throw new WorldException("no entity has the id %d".formatted(id));
        }
        idsByName.remove(entity.name());
        left.add(id);
        if (entity instanceof WorldObject object) {
            bodies.remove(object);
        }
        objects = Optional.empty();
        others = Optional.empty();
        fieldsChanged(entity);
    }

    private void fieldsChanged(Entity entity) {
        if (entity instanceof Field) {
            List<Field<?>> fields = new ArrayList<>();
            for (Entity other : byId.values()) {
                if (other instanceof Field<?> field) {
                    fields.add(field);
                }
            }
            bodies.state().setFields(fields);
        }
    }

    /** Puts an entity that is no body in the place of its former self. */
    void replace(Entity before, Entity changed) {
        if (before instanceof RigidBody) {
            throw new WorldException(
                    "'%s' is a body, which changes by its momenta and components, not as a whole"
                            .formatted(before.name()));
        }
        if (before.id() != changed.id() || !before.name().equals(changed.name())) {
            throw new WorldException(
                    "entity %d '%s' cannot turn into %d '%s': id and name stay"
                            .formatted(before.id(), before.name(), changed.id(), changed.name()));
        }
        byId.put(changed.id(), changed);
        others = Optional.empty();
        fieldsChanged(changed);
    }

    private WorldException unknown(String what) {
        return new WorldException("no world object has %s; there are %s".formatted(what, names()));
    }

    private String names() {
        List<WorldObject> all = objects();
        if (all.isEmpty()) {
            return "none";
        }
        StringBuilder text = new StringBuilder();
        for (WorldObject object : all.subList(0, Math.min(8, all.size()))) {
            text.append(text.isEmpty() ? "" : ", ");
            text.append("%d '%s'".formatted(object.id(), object.name()));
        }
        return all.size() > 8
                ? text.append(" and %d more".formatted(all.size() - 8)).toString()
                : text.toString();
    }
}
