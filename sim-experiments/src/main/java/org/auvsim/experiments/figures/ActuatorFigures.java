package org.auvsim.experiments.figures;

import org.auvsim.core.actuator.Fin;
import org.auvsim.core.actuator.PolynomialThrust;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.math.Numbers;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;

/** A figure for propulsors, one for fins. */
final class ActuatorFigures {
    private static final double INSTANT = 1e-6;

    private ActuatorFigures() {}

    static List<Figure> all() {
        return List.of(propulsor(), fin());
    }

    private static Figure propulsor() {
        return new Figure(
                "propulsor",
                "Thrust up to 40 N, by the square of the level: full ahead at 0 s, astern at 2 s",
                "time (s)",
                "thrust (N)",
                List.of(lagging("at once", 0), lagging("lag 0.3 s", 0.3)));
    }

    private static Series lagging(String name, double lag) {
        Propulsor ahead =
                new Propulsor(
                                "screw",
                                40,
                                0,
                                Vec3.ZERO,
                                new Vec3(1, 0, 0),
                                Optional.of(new PolynomialThrust(Numbers.of(0, 40))),
                                lag,
                                0,
                                0,
                                0,
                                Optional.empty(),
                                Optional.empty(),
                                Optional.empty(),
                                Optional.empty())
                        .commanded(1, 0);
        Propulsor astern = ahead.commanded(-1, 2);
        return Series.of(name, 0, 4, t -> (t < 2 ? ahead : astern).thrustAt(t));
    }

    private static Figure fin() {
        return new Figure(
                "fin",
                "A fin with a lift slope of 3 per rad that stalls at 20 degrees",
                "angle of attack (degrees)",
                "coefficient",
                List.of(
                        Series.of("C_L", 0, 90, a -> coefficient(a, v -> v.y())),
                        Series.of("C_D", 0, 90, a -> coefficient(a, v -> -v.x()))));
    }

    /** Of the force on a fin of 2 m^2 that moves at 1 m/s through water of 1 kg/m^3: the force. */
    private static double coefficient(double degrees, ToDoubleFunction<Vec3> component) {
        Fin fin =
                new Fin(
                        "fin",
                        2,
                        3,
                        Vec3.ZERO,
                        new Vec3(1, 0, 0),
                        new Vec3(0, 0, 1),
                        0.02,
                        0.1,
                        StrictMath.toRadians(20),
                        1,
                        0,
                        StrictMath.toRadians(degrees),
                        Math.PI,
                        OptionalDouble.empty(),
                        Optional.empty());
        World world =
                World.builder()
                        .timeStep(INSTANT)
                        .add(Trial.ball().velocity(1, 0, 0).component(fin).build())
                        .build();
        WorldObject body = world.objects().getFirst();
        Vec3 before = body.linearMomentum();
        world.advanceTimestep();
        return component.applyAsDouble(body.linearMomentum().minus(before).times(1 / INSTANT));
    }
}
