package org.auvsim.core.behavior;

import org.auvsim.core.description.Default;
import org.auvsim.core.description.Unit;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Vec3;

import java.util.List;

/**
 * Applies a force that changes at given times; it bears the behavior's name. What a row sets holds
 * until the next row; before the first row there is no force.
 *
 * @param frame the axes of the rows' vectors
 * @param timedForce the rows, in order of time
 */
public record ForceSchedule(String name, @Default("BODY") Frame frame, List<TimedForce> timedForce)
        implements Behavior {
    /** From {@code at} (s) on, {@code vector} (N) acts at {@code point} (m, body coordinates). */
    public record TimedForce(
            @Unit("s") double at,
            @Unit("N") Vec3 vector,
            @Unit("m") @Default("0 0 0") Vec3 point) {}

    /**
     * A checked schedule.
     *
     * @throws IllegalArgumentException if rows are not in order of time
     */
    public ForceSchedule {
        timedForce = List.copyOf(timedForce);
        Timetable.requireOrder(name, timedForce, TimedForce::at);
    }

    @Override
    public void act(double time, WorldObject self) {
        Timetable.at(time, timedForce, TimedForce::at)
                .map(row -> new NamedForce(name, frame, row.vector(), row.point()))
                .ifPresent(self::applyForce);
    }
}
