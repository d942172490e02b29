package org.auvsim.experiments.vehicle;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.Held;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;

import java.util.Optional;
import java.util.OptionalDouble;

/** How fast a vehicle becomes at full thrust, held to one way as by the carriage of a tank. */
final class TerminalSpeeds {
    private static final double STEP = 0.02;
    private static final double LOOK = 5;
    private static final double LONGEST = 600;
    private static final double STEADY = 1e-5;
    private static final double ASIDE = 1e-3;

    private TerminalSpeeds() {}

    /**
     * The speed (m/s) along a unit vector of its axes with all thrusters that help at full level;
     * empty if none does, or if it never becomes steady.
     */
    static OptionalDouble along(WorldObjectDefinition vehicle, Vec3 axis) {
        if (vehicle.component().stream()
                .noneMatch(c -> c instanceof Propulsor p && level(p, axis) != 0)) {
            return OptionalDouble.empty();
        }
        Held carriage = new Held(axis.x() == 0, axis.y() == 0, axis.z() == 0, true, true, true);
        World world = TestTank.with(vehicle, Optional.of(carriage), STEP, p -> level(p, axis));
        WorldObject body = world.objects().getFirst();
        double before = Double.NEGATIVE_INFINITY;
        while (world.time() < LONGEST) {
            for (double end = world.time() + LOOK; world.time() < end; ) {
                world.advanceTimestep();
            }
            double speed = body.velocity().dot(axis);
            if (Math.abs(speed - before) < STEADY * (1 + Math.abs(speed))) {
                return OptionalDouble.of(speed);
            }
            before = speed;
        }
        return OptionalDouble.empty();
    }

    private static double level(Propulsor propulsor, Vec3 axis) {
        double along = propulsor.direction().dot(axis);
        return Math.abs(along) < ASIDE ? 0 : Math.signum(along);
    }
}
