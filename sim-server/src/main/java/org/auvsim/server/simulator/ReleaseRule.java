package org.auvsim.server.simulator;

import org.auvsim.auvsml.document.ReleasedForces;
import org.auvsim.auvsml.document.ReleasedObject;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.effect.Brake;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.MassProperties;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;

import java.util.Collections;
import java.util.List;

/**
 * What becomes of an object that nobody controls any more. All that it does is in the world's
 * state, so that copies of the world go on alike.
 */
record ReleaseRule(ReleasedObject choice) {
    /** Below this speed (m/s) and rate (rad/s), or in a step, a brake's force falls to nothing. */
    private static final double SLIP = 0.05;

    /** A client has let go of an object. */
    void letGo(World world, WorldObject object) {
        if (choice.forces() == ReleasedForces.KEEP) {
            return;
        }
        object.setForces(object.definition().force());
        for (Propulsor propulsor : object.components(Propulsor.class)) {
            object.command(Propulsor.class, propulsor.name(), 0);
        }
        if (choice.forces() == ReleasedForces.BRAKE && !object.isFixed()) {
            world.addEffect(object.id(), brake(world, object));
        }
    }

    /** A client takes an object: it brakes no longer. */
    void takeUp(World world, WorldObject object) {
        if (choice.forces() != ReleasedForces.BRAKE || object.isFixed()) {
            return;
        }
        Brake brake = brake(world, object);
        if (count(object.effects(), brake) > count(object.definition().effect(), brake)) {
            world.removeEffect(object.id(), brake);
        }
    }

    private static int count(List<Effect> effects, Brake brake) {
        return Collections.frequency(effects, brake);
    }

    private Brake brake(World world, WorldObject object) {
        MassProperties properties = object.definition().massProperties().orElseThrow();
        double a = choice.deceleration();
        double alpha = choice.angularDeceleration();
        return new Brake(
                a * properties.mass(),
                new Vec3(
                                properties.inertia().xx(),
                                properties.inertia().yy(),
                                properties.inertia().zz())
                        .times(alpha),
                Math.max(SLIP, a * world.timeStep()),
                Math.max(SLIP, alpha * world.timeStep()));
    }
}
