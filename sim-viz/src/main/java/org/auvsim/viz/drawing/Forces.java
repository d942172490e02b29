package org.auvsim.viz.drawing;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.viz.scene.ActorView;
import org.auvsim.viz.scene.SceneLook;

/**
 * Arrows of the forces that somebody has set and of the thrust of propulsors, where they act. What
 * would give the object 1 m/s^2 is as long as the object.
 */
final class Forces implements Part {
    private static final double LONGEST = 4;

    private final Arrow arrow = new Arrow();
    private final Placement place = new Placement();
    private double size;

    @Override
    public void paint(SceneLook look, Picture picture) {
        if (!picture.options().shows(Layer.FORCES)) {
            return;
        }
        for (int i = 0; i < look.count(); i++) {
            ActorView actor = look.actor(i);
            if (actor.object().definition().isPresent() && !actor.object().isFixed()) {
                place.of(actor);
                size = 2 * actor.radius();
                forces(actor, actor.object().definition().get(), look.time(), picture);
            }
        }
    }

    private void forces(
            ActorView actor, WorldObjectDefinition definition, double time, Picture picture) {
        for (int k = 0; k < actor.forces().size(); k++) {
            NamedForce force = actor.forces().get(k);
            boolean inWorld = force.frame() == Frame.WORLD;
            push(
                    definition,
                    force.point().x(),
                    force.point().y(),
                    force.point().z(),
                    inWorld ? force.vector().x() : turned(0, force),
                    inWorld ? force.vector().y() : turned(1, force),
                    inWorld ? force.vector().z() : turned(2, force),
                    Palette.FORCE,
                    picture);
        }
        for (int k = 0; k < definition.component().size(); k++) {
            Component component = definition.component().get(k);
            if (component instanceof Propulsor propulsor) {
                thrust(definition, propulsor, propulsor.thrustAt(time), picture);
            }
        }
    }

    private double turned(int axis, NamedForce force) {
        return place.world(axis, force.vector().x(), force.vector().y(), force.vector().z());
    }

    private void thrust(
            WorldObjectDefinition definition, Propulsor propulsor, double thrust, Picture picture) {
        double x = thrust * propulsor.direction().x();
        double y = thrust * propulsor.direction().y();
        double z = thrust * propulsor.direction().z();
        push(
                definition,
                propulsor.position().x(),
                propulsor.position().y(),
                propulsor.position().z(),
                place.world(0, x, y, z),
                place.world(1, x, y, z),
                place.world(2, x, y, z),
                Palette.THRUST,
                picture);
    }

    /** A force (N, world) at a point (m, body). */
    private void push(
            WorldObjectDefinition definition,
            double px,
            double py,
            double pz,
            double fx,
            double fy,
            double fz,
            int colour,
            Picture picture) {
        double strength = Math.sqrt(fx * fx + fy * fy + fz * fz);
        if (strength == 0 || definition.mass().isEmpty()) {
            return;
        }
        double length =
                size * Math.min(strength / definition.mass().getAsDouble(), LONGEST) / strength;
        arrow.paint(
                place.pose.x + place.world(0, px, py, pz),
                place.pose.y + place.world(1, px, py, pz),
                place.pose.z + place.world(2, px, py, pz),
                fx * length,
                fy * length,
                fz * length,
                colour,
                picture);
    }
}
