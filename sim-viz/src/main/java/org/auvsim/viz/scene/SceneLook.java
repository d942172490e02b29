package org.auvsim.viz.scene;

import org.auvsim.core.entity.Field;

import java.util.List;

/** What a scene shows at one instant; to be read while looking, and not kept. */
public interface SceneLook {
    /** The world's time that is shown (s). */
    double time();

    /** How many objects there are. */
    int count();

    /** Object {@code i}, in order of their coming. */
    ActorView actor(int i);

    /** What fills the world: currents and other fields. */
    List<Field<?>> fields();

    /** How the water moves; the same one until the fields are others. */
    Water water();

    /** The last collisions, the newest first. */
    List<Meeting> meetings();
}
