package org.auvsim.server.simulator;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.auvsml.message.command.WorldObjectControl;
import org.auvsim.core.actuator.Fin;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.communication.Transceiver;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.world.World;

/** One world object as commands reach it. */
record WorldObjectPort(World world, WorldObject object) implements WorldObjectControl {
    @Override
    public void apply(NamedForce force) {
        if (!object.volume().contains(force.point())) {
            throw new RefusedException(
                    ErrorCode.INVALID_VALUE,
                    "the point %s of force '%s' lies outside the volume of '%s'"
                            .formatted(force.point(), force.name(), object.name()));
        }
        object.applyForce(force);
    }

    @Override
    public void removeForce(String name) {
        if (!object.removeForce(name)) {
            throw new RefusedException(
                    ErrorCode.UNKNOWN_ENTITY,
                    "'%s' has no force '%s'; it has %s"
                            .formatted(
                                    object.name(),
                                    name,
                                    object.forces().stream().map(NamedForce::name).toList()));
        }
    }

    @Override
    public void setPropulsorLevel(String name, double level) {
        object.command(Propulsor.class, name, level);
    }

    @Override
    public void setControlSurface(String name, double angle) {
        object.command(Fin.class, name, angle);
    }

    @Override
    public void transmit(Class<? extends Transceiver> kind, String transceiver, String text) {
        world.transmit(object.id(), kind, transceiver, text);
    }
}
