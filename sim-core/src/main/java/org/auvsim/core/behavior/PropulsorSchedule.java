package org.auvsim.core.behavior;

import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Propulsor;
import org.auvsim.core.entity.WorldObject;

import java.util.List;

/**
 * Sets the level of one propulsor at given times; what a row sets holds until the next row.
 *
 * @param propulsor name of a propulsor of the same object; one that it lacks is left alone
 * @param timedLevel the rows, in order of time
 */
public record PropulsorSchedule(String name, String propulsor, List<TimedLevel> timedLevel)
        implements Behavior {
    /** From {@code at} (s) on, the propulsor runs at {@code level}, -1 to 1. */
    public record TimedLevel(@Unit("s") double at, double level) {
        /**
         * A checked row.
         *
         * @throws IllegalArgumentException if the level is outside [-1, 1]
         */
        public TimedLevel {
            if (!(level >= -1 && level <= 1)) {
                throw new IllegalArgumentException(
                        "the level at " + at + " s must be -1 to 1, but is " + level);
            }
        }
    }

    /**
     * A checked schedule.
     *
     * @throws IllegalArgumentException if rows are not in order of time
     */
    public PropulsorSchedule {
        timedLevel = List.copyOf(timedLevel);
        Timetable.requireOrder(name, timedLevel, TimedLevel::at);
    }

    @Override
    public void act(double time, WorldObject self) {
        if (self.component(Propulsor.class, propulsor).isPresent()) {
            Timetable.at(time, timedLevel, TimedLevel::at)
                    .ifPresent(row -> self.setPropulsorLevel(propulsor, row.level()));
        }
    }
}
