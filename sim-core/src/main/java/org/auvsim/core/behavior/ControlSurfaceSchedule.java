package org.auvsim.core.behavior;

import org.auvsim.core.actuator.Fin;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Need;
import org.auvsim.core.entity.WorldObject;

import java.util.List;
import java.util.Optional;

/**
 * Sets the angle of one fin at given times; what a row sets holds until the next row.
 *
 * @param fin name of a fin of the same object; an object that lacks it is refused
 * @param timedAngle the rows, in order of time
 */
public record ControlSurfaceSchedule(String name, String fin, List<TimedAngle> timedAngle)
        implements Behavior {
    /** From {@code at} (s) on, the fin goes to or stays at {@code angle} (rad). */
    public record TimedAngle(@Unit("s") double at, @Unit("rad") double angle) {
        /**
         * A checked row.
         *
         * @throws IllegalArgumentException if the angle is not finite
         */
        public TimedAngle {
            if (!Double.isFinite(angle)) {
                throw new IllegalArgumentException(
                        "the angle at " + at + " s must be finite, but is " + angle + " rad");
            }
        }
    }

    /**
     * A checked schedule.
     *
     * @throws IllegalArgumentException if rows are not in order of time
     */
    public ControlSurfaceSchedule {
        timedAngle = List.copyOf(timedAngle);
        Timetable.requireOrder(name, timedAngle, TimedAngle::at);
    }

    @Override
    public Optional<Need> needs() {
        return Optional.of(Need.named(Fin.class, fin));
    }

    @Override
    public void act(double time, WorldObject self) {
        Timetable.at(time, timedAngle, TimedAngle::at)
                .ifPresent(row -> self.command(Fin.class, fin, row.angle()));
    }
}
