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

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;

/**
 * What a running simulation believed of one of its objects before anything was learned, and what it
 * has learned since. All that is measured is diagnosed against the former: so what was learned from
 * little is learned again from more, and not added to. Behaviors are left out of it: what they tell
 * actuators is among the commands. A battery tells them nothing, and stays: propulsors draw from
 * it.
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
    /** That of an object in a world as it is now. */
    static Belief of(World world, long objectId) {
        WorldObjectDefinition object = world.object(objectId).presentDefinition();
        List<Component> behaviors =
                object.component().stream()
                        .filter(c -> c instanceof Behavior && !(c instanceof Battery))
                        .toList();
        List<Component> others = new ArrayList<>(object.component());
        others.removeAll(behaviors);
        WorldObjectDefinition body = object.toBuilder().components(others).build();
        return new Belief(
                new BelievedModel(
                        Scenario.of(world).with(world.fields(), List.of(body)), object.name()),
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
        Scenario scenario = first.scenario();
        return new BelievedModel(
                scenario.with(scenario.field(), List.of(object.build())), first.body());
    }

    /** What makes the running world believe what a diagnosis of a model has found. */
    List<Message> changes(BelievedModel diagnosed, Scenario found) {
        List<Message> changes = new ArrayList<>();
        fields.forEach(field -> changes.add(new RemoveEntityCommand(field.id())));
        added(diagnosed, found).forEach(field -> changes.add(new AddFieldCommand(field)));
        WorldObjectDefinition before = body.orElse(diagnosed.variant().body());
        WorldObjectDefinition after = body(found);
        if (!after.equals(before)) {
            List<Component> components = new ArrayList<>(after.component());
            components.addAll(behaviors);
            changes.add(
                    new ReviseWorldObjectCommand(after.toBuilder().components(components).build()));
        }
        return changes;
    }

    /** When the running world has them. */
    Belief after(BelievedModel diagnosed, Scenario found) {
        List<Field<?>> added = added(diagnosed, found);
        return new Belief(first, behaviors, added, Optional.of(body(found)), given + added.size());
    }

    /** Diagnoses begin with the same ids each time: they are counted on from those given before. */
    private List<Field<?>> added(BelievedModel diagnosed, Scenario found) {
        List<Field<?>> added = new ArrayList<>(found.field());
        added.removeAll(diagnosed.scenario().field());
        added.replaceAll(field -> Renumbered.field(field, field.id() + given));
        return added;
    }

    private WorldObjectDefinition body(Scenario found) {
        return new BelievedModel(found, first.body()).variant().body();
    }
}
