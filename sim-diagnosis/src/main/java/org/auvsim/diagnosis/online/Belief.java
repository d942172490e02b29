package org.auvsim.diagnosis.online;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.entity.AddFieldCommand;
import org.auvsim.auvsml.message.entity.RemoveEntityCommand;
import org.auvsim.auvsml.message.entity.ReviseWorldObjectCommand;
import org.auvsim.core.actuator.Battery;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.Field;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Variant;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;

/**
 * What a running simulation believed of one of its objects before anything was learned, and what it
 * has learned since. All that is measured is diagnosed against the former: so what was learned from
 * little is learned again from more, and not added to. What is fixed belongs to it: the object may
 * rest on a floor. Behaviors are left out of it: what they tell actuators is among the commands. A
 * battery tells them nothing, and stays: propulsors draw from it.
 *
 * @param first before anything was learned
 * @param behaviors that the object has
 * @param fields that the world has been given
 * @param body that it was given
 * @param given how many fields it was ever given; their ids are not used again
 */
record Belief(
        BelievedModel first,
        List<Component> behaviors,
        List<Field<?>> fields,
        Optional<WorldObjectDefinition> body,
        int given) {
    /** Fields that are learned have ids from here on, beside those of the world. */
    private static final long FIRST_ID = 1_000_001;

    /** That of an object in a world as it is now. */
    static Belief of(World world, long objectId) {
        WorldObjectDefinition object = world.object(objectId).presentDefinition();
        List<Component> behaviors =
                object.component().stream()
                        .filter(c -> c instanceof Behavior && !(c instanceof Battery))
                        .toList();
        List<Component> others = new ArrayList<>(object.component());
        others.removeAll(behaviors);
        Scenario now = Scenario.of(world);
        List<WorldObjectDefinition> kept = new ArrayList<>(now.worldObject());
        kept.removeIf(other -> other.name().equals(object.name()));
        kept.add(object.toBuilder().components(others).build());
        return new Belief(
                new BelievedModel(now.with(now.field(), kept), object.name()),
                behaviors,
                List.of(),
                Optional.empty(),
                0);
    }

    /** The first model of a body on which these forces may act: what they are, commands tell. */
    BelievedModel under(Collection<NamedForce> forces) {
        WorldObjectDefinition.Builder object = first.variant().body().toBuilder();
        for (NamedForce force : forces) {
            if (first.variant().body().force().stream()
                    .noneMatch(known -> known.name().equals(force.name()))) {
                object.force(new NamedForce(force.name(), force.frame(), Vec3.ZERO, force.point()));
            }
        }
        Variant pushed = first.variant().with(_ -> object);
        return new BelievedModel(first.extended(pushed), first.body());
    }

    /** With what a diagnosis of a model has found in place of all that was learned before. */
    Belief learning(BelievedModel diagnosed, Scenario found) {
        List<Field<?>> added = new ArrayList<>(found.field());
        added.removeAll(diagnosed.scenario().field());
        WorldObjectDefinition object = new BelievedModel(found, first.body()).variant().body();
        boolean isOther = !object.equals(diagnosed.variant().body());
        return new Belief(
                first,
                behaviors,
                numbered(added),
                isOther ? Optional.of(object) : Optional.empty(),
                given + added.size());
    }

    /** As it was before anything was learned. */
    Belief unlearning() {
        return new Belief(first, behaviors, List.of(), Optional.empty(), given);
    }

    /** Whether anything was learned of the world. */
    boolean hasLearned() {
        return !fields.isEmpty() || body.isPresent();
    }

    /** What makes the running world, which has this, have another one. */
    List<Message> changes(Belief next) {
        List<Message> changes = new ArrayList<>();
        for (Field<?> field : fields) {
            if (!next.fields.contains(field)) {
                changes.add(new RemoveEntityCommand(field.id()));
            }
        }
        for (Field<?> field : next.fields) {
            if (!fields.contains(field)) {
                changes.add(new AddFieldCommand(field));
            }
        }
        if (!next.object().equals(object())) {
            changes.add(new ReviseWorldObjectCommand(next.acting()));
        }
        return changes;
    }

    /**
     * What the world has after some of the changes to another one.
     *
     * @param made those that were carried out
     */
    Belief partWay(Belief next, List<Message> made) {
        List<Field<?>> there = new ArrayList<>(fields);
        Optional<WorldObjectDefinition> now = body;
        for (Message change : made) {
            switch (change) {
                case RemoveEntityCommand(long id) -> there.removeIf(field -> field.id() == id);
                case AddFieldCommand(Field<?> field) -> there.add(field);
                default -> now = next.body;
            }
        }
        return new Belief(first, behaviors, there, now, next.given);
    }

    /** What was there before, as the world can have it again: what has left is another one then. */
    Belief again(Belief before) {
        List<Field<?>> left = new ArrayList<>(before.fields);
        left.removeAll(fields);
        List<Field<?>> all = new ArrayList<>(before.fields);
        all.retainAll(fields);
        all.addAll(numbered(left));
        return new Belief(first, behaviors, all, before.body, given + left.size());
    }

    /** Under ids that were not used before: those of entities that have left are not free. */
    private List<Field<?>> numbered(List<Field<?>> some) {
        long next = FIRST_ID + first.scenario().field().size() + given;
        List<Field<?>> numbered = new ArrayList<>();
        for (Field<?> field : some) {
            numbered.add(Renumbered.field(field, next + numbered.size()));
        }
        return numbered;
    }

    private WorldObjectDefinition object() {
        return body.orElseGet(() -> first.variant().body());
    }

    /** With its behaviors. */
    private WorldObjectDefinition acting() {
        List<Component> components = new ArrayList<>(object().component());
        components.addAll(behaviors);
        return object().toBuilder().components(components).build();
    }
}
