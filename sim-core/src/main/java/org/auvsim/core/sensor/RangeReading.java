package org.auvsim.core.sensor;

import org.auvsim.core.description.Unit;

import java.util.List;

/**
 * What a range sonar read: an echo for each beam that met something in its range.
 *
 * @param echo in order of their beams
 */
public record RangeReading(List<Echo> echo) implements SensorReading {
    /** A list that cannot be changed. */
    public RangeReading {
        echo = List.copyOf(echo);
    }

    /**
     * One echo.
     *
     * @param beam its number, from 0 on
     * @param distance to what the beam met
     */
    public record Echo(int beam, @Unit("m") double distance) {}
}
