package org.auvsim.core.world;

import org.auvsim.core.entity.Change;
import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.Entity;
import org.auvsim.core.entity.WorldObject;

import java.util.Optional;

/** Makes the changes to a world that collision responses have asked for. */
final class Consequences {
    private final World world;
    private final Population population;
    private final Mechanics mechanics;
    private final Announcements announcements;

    /** For a world, who is in it, and how they move. */
    Consequences(
            World world, Population population, Mechanics mechanics, Announcements announcements) {
        this.world = world;
        this.population = population;
        this.mechanics = mechanics;
        this.announcements = announcements;
    }

    /** Makes one change; one that is for somebody who has left comes to nothing. */
    void apply(Change change) {
        switch (change) {
            case Change.Momentum m -> addMomentum(m);
            case Change.AddEntity added -> world.add(added.made().apply(population.nextId()));
            case Change.AddObject added -> world.add(added.definition());
            case Change.Tell told -> tell(told);
            case Change.Update<?> updated -> update(updated);
            case Change.Remove removed -> {
                if (population.find(removed.entityId()).isPresent()) {
                    world.remove(removed.entityId());
                }
            }
            case Change.UpdateComponents<?> updated -> updateComponents(updated);
        }
    }

    private void addMomentum(Change.Momentum m) {
        population
                .findObject(m.objectId())
                .ifPresent(
                        object -> {
                            object.setLinearMomentum(object.linearMomentum().plus(m.linear()));
                            object.setAngularMomentum(object.angularMomentum().plus(m.angular()));
                        });
    }

    private void tell(Change.Tell told) {
        if (population.findObject(told.objectId()).isPresent()) {
            announcements.announce(
                    new WorldEvent.SignalReceived(told.time(), told.objectId(), told.signal()));
        }
    }

    private <E extends Entity> void update(Change.Update<E> updated) {
        Optional<Entity> before = population.find(updated.entityId());
        if (before.isPresent() && updated.type().isInstance(before.get())) {
            E entity = updated.type().cast(before.get());
            population.replace(entity, updated.update().apply(entity));
            mechanics.changed();
        }
    }

    private <C extends Component> void updateComponents(Change.UpdateComponents<C> updated) {
        Optional<WorldObject> object = population.findObject(updated.objectId());
        if (object.isPresent()) {
            for (C component : object.get().components(updated.type())) {
                object.get().replace(updated.update().apply(component));
            }
        }
    }
}
