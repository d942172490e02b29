package org.auvsim.server.simulator;

import org.auvsim.auvsml.ErrorCode;
import org.auvsim.auvsml.message.command.ListedWorldObject;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.auvsml.message.command.WorldControl;
import org.auvsim.core.actuator.Fin;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Field;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.GriddedCurrent;
import org.auvsim.core.sensor.Sensor;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldException;

import java.util.List;

/** The world as commands reach it. */
record WorldPort(World world, DescriptionLimits limits) implements WorldControl {
    /** Grids of more points than this are not told: no client could take the message. */
    private static final int MOST_GRID_POINTS = 20_000;

    /**
     * The world object with an id.
     *
     * @throws RefusedException if there is none
     */
    static WorldObject object(World world, long id) {
        try {
            return world.object(id);
        } catch (WorldException e) {
            throw new RefusedException(ErrorCode.UNKNOWN_ENTITY, String.valueOf(e.getMessage()));
        }
    }

    @Override
    public List<ListedWorldObject> worldObjects() {
        return world.objects().stream()
                .map(o -> new ListedWorldObject(o.id(), ListedWorldObject.WORLD_OBJECT, o.name()))
                .toList();
    }

    @Override
    public List<String> propulsorNames(long worldObjectId) {
        return object(world, worldObjectId).components(Propulsor.class).stream()
                .map(Propulsor::name)
                .toList();
    }

    @Override
    public List<String> controlSurfaceNames(long worldObjectId) {
        return object(world, worldObjectId).components(Fin.class).stream()
                .filter(fin -> fin.maximumAngle() > 0)
                .map(Fin::name)
                .toList();
    }

    @Override
    public List<Effect> effects(long worldObjectId) {
        return object(world, worldObjectId).effects();
    }

    @Override
    public WorldObjectDefinition description(long worldObjectId) {
        WorldObjectDefinition definition = object(world, worldObjectId).presentDefinition();
        limits.requireReadable(definition);
        return definition;
    }

    @Override
    public List<Field<?>> fields() {
        long numbers = 0;
        for (Field<?> field : world.fields()) {
            numbers += field instanceof GriddedCurrent grid ? grid.u().size() : 0;
        }
        if (numbers > MOST_GRID_POINTS) {
            throw new RefusedException(
                    ErrorCode.REFUSED,
                    "the grids of the world's currents have %d points, too many for a message (%d)"
                            .formatted(numbers, MOST_GRID_POINTS));
        }
        return world.fields();
    }

    @Override
    public void add(Field<?> field) {
        world.add(field);
    }

    @Override
    public List<Sensor> sensors(long worldObjectId) {
        return object(world, worldObjectId).components(Sensor.class);
    }

    @Override
    public long add(WorldObjectDefinition definition) {
        return world.add(definition).id();
    }

    @Override
    public void revise(WorldObjectDefinition definition) {
        world.revise(definition);
    }

    @Override
    public void remove(long entityId) {
        if (world.find(entityId).isEmpty()) {
            throw new RefusedException(
                    ErrorCode.UNKNOWN_ENTITY, "no entity has the id %d".formatted(entityId));
        }
        world.remove(entityId);
    }

    @Override
    public void addEffect(long worldObjectId, Effect effect) {
        world.addEffect(object(world, worldObjectId).id(), effect);
    }

    @Override
    public void removeEffect(long worldObjectId, Effect effect) {
        WorldObject object = object(world, worldObjectId);
        if (!world.removeEffect(object.id(), effect)) {
            throw new RefusedException(
                    ErrorCode.UNKNOWN_ENTITY,
                    "'%s' has no such effect; get-effect-list-request tells which it has, to the number"
                            .formatted(object.name()));
        }
    }
}
