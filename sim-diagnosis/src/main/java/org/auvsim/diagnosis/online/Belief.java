package org.auvsim.diagnosis.online;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.entity.AddFieldCommand;
import org.auvsim.auvsml.message.entity.ReviseWorldObjectCommand;
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

/**
 * What a running simulation believes of one of its objects. Behaviors are left out of it: what they
 * tell actuators is among the commands.
 *
 * @param behaviors that the object has
 */
record Belief(BelievedModel model, List<Component> behaviors) {
    /** That of an object in a world as it is now. */
    static Belief of(World world, long objectId) {
        WorldObjectDefinition object = world.object(objectId).presentDefinition();
        List<Component> behaviors =
                object.component().stream().filter(Behavior.class::isInstance).toList();
        List<Component> others = new ArrayList<>(object.component());
        others.removeAll(behaviors);
        WorldObjectDefinition body = object.toBuilder().components(others).build();
        return new Belief(
                new BelievedModel(
                        Scenario.of(world).with(world.fields(), List.of(body)), object.name()),
                behaviors);
    }

    /** The same model of a body on which these forces may act: what they are, commands tell. */
    BelievedModel under(Collection<NamedForce> forces) {
        WorldObjectDefinition.Builder body = model.variant().body().toBuilder();
        for (NamedForce force : forces) {
            if (model.variant().body().force().stream()
                    .noneMatch(known -> known.name().equals(force.name()))) {
                body.force(new NamedForce(force.name(), force.frame(), Vec3.ZERO, force.point()));
            }
        }
        return believing(model.scenario().with(model.scenario().field(), List.of(body.build())));
    }

    private BelievedModel believing(Scenario scenario) {
        return new BelievedModel(scenario, model.body());
    }

    /** What a diagnosis of this has found, believed from now on. */
    Belief extended(Scenario found) {
        return new Belief(believing(found), behaviors);
    }

    /** What makes a running world believe what a diagnosis of this has found. */
    List<Message> changes(Scenario found) {
        List<Message> changes = new ArrayList<>();
        for (Field<?> field : found.field()) {
            if (!model.scenario().field().contains(field)) {
                changes.add(new AddFieldCommand(field));
            }
        }
        WorldObjectDefinition before = model.variant().body();
        WorldObjectDefinition after = believing(found).variant().body();
        if (!after.equals(before)) {
            List<Component> components = new ArrayList<>(after.component());
            components.addAll(behaviors);
            changes.add(
                    new ReviseWorldObjectCommand(after.toBuilder().components(components).build()));
        }
        return changes;
    }
}
