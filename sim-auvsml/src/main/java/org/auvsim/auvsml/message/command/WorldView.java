package org.auvsim.auvsml.message.command;

import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Field;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.sensor.Sensor;

import java.util.List;

/** What a {@link WorldQuery} can ask. */
public interface WorldView {
    /** All world objects, in order of id. */
    List<ListedWorldObject> worldObjects();

    /**
     * The names of an object's propulsors, in the order in which they were added.
     *
     * @throws RefusedException if there is no such world object
     */
    List<String> propulsorNames(long worldObjectId);

    /**
     * The names of the fins of a world object that can be turned.
     *
     * @throws RefusedException if there is no such object
     */
    List<String> controlSurfaceNames(long worldObjectId);

    /**
     * An object's sensors, in the order in which they were added.
     *
     * @throws RefusedException if there is no such world object
     */
    List<Sensor> sensors(long worldObjectId);

    /**
     * What acts on an object, in the order of its coming.
     *
     * @throws RefusedException if there is no such world object
     */
    List<Effect> effects(long worldObjectId);

    /**
     * An object as it is now, described as in a scenario, with its id.
     *
     * @throws RefusedException if there is no such world object, or its description is too long for
     *     a client
     */
    WorldObjectDefinition description(long worldObjectId);

    /** All fields, in order of id. */
    List<Field<?>> fields();
}
