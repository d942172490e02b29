package org.auvsim.core.sensor;

import org.auvsim.core.entity.Component;
import org.auvsim.core.entity.Current;
import org.auvsim.core.entity.Field;
import org.auvsim.core.math.Vec3;

import java.util.List;
import java.util.Optional;

/** The world around a sensor at the instant of its measurement. */
public interface Scene {
    /** Where the world is on Earth. */
    Optional<Datum> datum();

    /** All fields of a type, in order of id. */
    <F extends Field<?>> List<F> fields(Class<F> type);

    /** All currents, in order of id, ready to be evaluated ({@link Current#prepared}). */
    List<Current> currents();

    /** The components of a type that the sensor's own object has, as they are after the step. */
    <C extends Component> List<C> components(Class<C> type);

    /**
     * What a ray meets first of other bodies, within a range.
     *
     * @param from where it begins (m, world)
     * @param direction of length 1 (world)
     * @param range (m)
     * @param what which bodies it can meet
     */
    Optional<Sighting> look(Vec3 from, Vec3 direction, double range, Target what);

    /** Which bodies a ray can meet. */
    enum Target {
        /** All but that of the sensor itself. */
        ANY_BODY,
        /** Those that are fixed: the bottom, walls. */
        FIXED_BODY
    }

    /**
     * What a ray has met.
     *
     * @param objectId whom
     * @param distance from the ray's beginning (m)
     */
    record Sighting(long objectId, double distance) {}
}
