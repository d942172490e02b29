package org.auvsim.core.sensor;

import org.auvsim.core.entity.Component;

import java.util.Optional;

/**
 * A component that measures. The world asks it for a reading at each of its instants, {@code k /
 * rate} on the world's clock, wherever these lie in a step.
 *
 * <p>A sensor is an immutable value. A reading is a function of the sample alone, whose noise is a
 * function of seed, object, sensor and {@code k}: the same world gives the same readings in every
 * run, on any number of threads and in every copy, whether somebody listens or not.
 */
public interface Sensor extends Component {
    /** When it measures, and what becomes of its readings on their way. */
    Sampling sampling();

    /** What it reads; empty if there is nothing to read, as for a GPS below the water. */
    Optional<SensorReading> read(Sample sample);

    /**
     * What it lacks in a world, as an object that has it is added there: a clause such as "needs a
     * datum"; empty if nothing.
     */
    default Optional<String> lacks(Optional<Datum> datum) {
        return Optional.empty();
    }

    /** Whether it looks at other bodies ({@link Scene#look}) at instants within a step. */
    default boolean looksAround() {
        return false;
    }
}
