package org.auvsim.core.behavior;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Need;
import org.auvsim.core.entity.WorldObject;

import java.util.List;
import java.util.Optional;

/**
 * Sets the level of one propulsor at given times; what a row sets holds until the next row.
 *
 * @param propulsor name of a propulsor of the same object; an object that lacks it is refused
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
    public Optional<Need> needs() {
        return Optional.of(Need.named(Propulsor.class, propulsor));
    }

    @Override
    public void act(double time, WorldObject self) {
        Timetable.at(time, timedLevel, TimedLevel::at)
                .ifPresent(row -> self.command(Propulsor.class, propulsor, row.level()));
    }
}
