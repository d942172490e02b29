package org.auvsim.experiments.hidden;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.apache.commons.math3.util.FastMath;
import org.auvsim.experiments.hidden.Manoeuvre.TimedPush;
import org.auvsim.experiments.hidden.Manoeuvre.Track;

import java.util.List;
import java.util.Map;
import java.util.function.Function;

/**
 * An effect that looks like another one, in runs that cannot tell them apart, or nearly the same in
 * runs that can.
 *
 * @param looseness factor by which velocities at the start are less known than usual
 */
record Puzzle(Body body, HiddenEffect hidden, Twins twins, double looseness) {
    private static final double DURATION = 25;
    private static final int RATE = 20;
    private static final double THRUST = 20;
    private static final double MASS = 15;

    /** Off the centre by so much (m) that nothing turns of it. */
    private static final double LEVER = 1e-6;

    /** Terminal speed (m/s) of a ball that is drawn evenly with what is hidden in it. */
    private static final double EVEN_SPEED = 0.6;

    private static final List<Function<Draws, Puzzle>> ALL =
            List.of(
                    Puzzle::massOrGain,
                    Puzzle::dragLaw,
                    Puzzle::delayOrClock,
                    Puzzle::weightOrBuoyancy,
                    Puzzle::massOrDrag,
                    Puzzle::currentOrDrift);

    static Puzzle draw(Draws draws) {
        return draws.oneOf(ALL).apply(draws);
    }

    private record Plain(String name, Plant believed, Function<Draws, Manoeuvre> runs)
            implements Body {
        @Override
        public Plant plant(Draws draws) {
            return believed;
        }

        @Override
        public double timeStep() {
            return 0.02;
        }

        @Override
        public boolean showsOrientation(Draws draws) {
            return false;
        }

        @Override
        public Manoeuvre manoeuvre(Draws draws) {
            return runs.apply(draws);
        }
    }

    /** A ball of 15 kg that floats where it is. */
    private static Plant ball(Drag drag, double displaced, List<Thruster> thrusters) {
        double moment = 0.135;
        return new Plant(
                new Vector3D(0.3, 0, 0),
                MASS,
                new Vector3D(moment, moment, moment),
                Vector3D.ZERO,
                Vector3D.ZERO,
                displaced > 0 ? Plant.GRAVITY : 0,
                displaced,
                Vector3D.ZERO,
                drag,
                thrusters,
                List.of());
    }

    /** Without drag only their ratio counts. */
    private static Puzzle massOrGain(Draws draws) {
        boolean areAlike = draws.chance(0.6);
        double factor = draws.between(1.15, 1.5);
        Plant sled =
                ball(
                        Drag.even(areAlike ? 0 : 12, 0, 0.1),
                        0,
                        List.of(
                                Thruster.sound(
                                        "propeller", Vector3D.ZERO, Vector3D.PLUS_I, THRUST)));
        HiddenEffect hidden =
                draws.chance(0.5)
                        ? HiddenEffect.of(
                                "mass_error",
                                Map.of("factor", Numbers.of(factor)),
                                r -> r.with(p -> p.withMass(factor * p.mass())))
                        : HiddenEffect.of(
                                        "thruster_gain",
                                        Map.of("factor", Numbers.of(1 / factor)),
                                        r ->
                                                r.with(
                                                        p ->
                                                                p.withThrusters(
                                                                        t ->
                                                                                t.withGain(
                                                                                        1
                                                                                                / factor))))
                                .about("propeller");
        return new Puzzle(
                new Plain("sled", sled, Puzzle::driven),
                hidden,
                new Twins("mass_error", "thruster_gain", areAlike),
                1);
    }

    private static Manoeuvre driven(Draws draws) {
        List<Integer> samples = Steps.draw(DURATION, RATE, 1, 4, draws);
        List<Double> levels =
                samples.stream().map(s -> s == 0 ? 0 : draws.between(-0.8, 0.8)).toList();
        return new Manoeuvre(
                still(new Vector3D(0, 0, -10), draws.normals(0.1), draws),
                DURATION,
                RATE,
                List.of(new Track("propeller", samples, levels)),
                List.of());
    }

    private static Instant still(Vector3D place, Vector3D velocity, Draws draws) {
        return new Instant(
                0,
                place,
                Attitude.turned(new Vector3D(0, 0, draws.between(-Math.PI, Math.PI))),
                velocity,
                Vector3D.ZERO,
                Vector3D.ZERO);
    }

    /** At one speed, linear and quadratic drag of the same force are the same. */
    private static Puzzle dragLaw(Draws draws) {
        boolean areAlike = draws.chance(0.6);
        boolean isLinear = draws.chance(0.5);
        double more = draws.between(4, 8);
        Drag drag = Drag.even(10, 0, 0.1);
        HiddenEffect hidden =
                isLinear
                        ? HiddenEffect.of(
                                "linear_drag",
                                Map.of("c", Numbers.of(more)),
                                r -> r.with(p -> p.withDrag(d -> d.withEven(more, 0, 0))))
                        : HiddenEffect.of(
                                "quadratic_drag",
                                Map.of("k", Numbers.of(more / EVEN_SPEED)),
                                r ->
                                        r.with(
                                                p ->
                                                        p.withDrag(
                                                                d ->
                                                                        d.withEven(
                                                                                0,
                                                                                more / EVEN_SPEED,
                                                                                0))));
        double pull = (10 + more) * EVEN_SPEED;
        return new Puzzle(
                new Plain(
                        "towed ball",
                        ball(drag, MASS, List.of()),
                        d -> areAlike ? towed(pull, d) : pushed(4, 40, d)),
                hidden,
                new Twins("linear_drag", "quadratic_drag", areAlike),
                1);
    }

    private static Manoeuvre towed(double pull, Draws draws) {
        double azimuth = draws.between(-Math.PI, Math.PI);
        Vector3D along = new Vector3D(FastMath.cos(azimuth), FastMath.sin(azimuth), 0);
        return new Manoeuvre(
                still(new Vector3D(0, 0, -10), along.scalarMultiply(EVEN_SPEED), draws),
                DURATION,
                RATE,
                List.of(),
                List.of(new TimedPush(0, DURATION + 1, along.scalarMultiply(pull), Vector3D.ZERO)));
    }

    private static Manoeuvre pushed(double least, double most, Draws draws) {
        return new Manoeuvre(
                still(new Vector3D(0, 0, -20), draws.normals(0.1), draws),
                DURATION,
                RATE,
                List.of(),
                new Pushing(least, most, LEVER).draw(DURATION, draws));
    }

    /** What sensors tell late and what a clock stamps late is the same. */
    private static Puzzle delayOrClock(Draws draws) {
        double delay = draws.between(0.1, 0.5);
        boolean isClock = draws.chance(0.5);
        return new Puzzle(
                new Plain(
                        "pushed ball",
                        ball(Drag.even(10, 0, 0.1), MASS, List.of()),
                        d -> pushed(4, 40, d)),
                HiddenEffect.of(
                        isClock ? "clock_offset" : "sensor_delay",
                        Map.of(isClock ? "offset" : "delay", Numbers.of(delay)),
                        r ->
                                r.sensed(
                                        q ->
                                                new Sensors(
                                                        delay,
                                                        q.scale(),
                                                        q.turn(),
                                                        q.yaw(),
                                                        q.yawRate()))),
                new Twins("sensor_delay", "clock_offset", true),
                1);
    }

    /** What sinks evenly may be heavier or displace less. */
    private static Puzzle weightOrBuoyancy(Draws draws) {
        boolean areAlike = draws.chance(0.6);
        boolean isMass = draws.chance(0.5);
        double heavier = draws.between(0.05, 0.15);
        double weight = heavier * MASS * Plant.GRAVITY;
        HiddenEffect hidden =
                isMass
                        ? HiddenEffect.of(
                                "mass_error",
                                Map.of("factor", Numbers.of(1 + heavier)),
                                r -> r.with(p -> p.withMass((1 + heavier) * p.mass())))
                        : HiddenEffect.of(
                                "buoyancy_weight",
                                Map.of("force", Numbers.of(-weight)),
                                r -> r.pushed(at -> Wrench.force(new Vector3D(0, 0, -weight))));
        double drag = 12;
        return new Puzzle(
                new Plain(
                        "sinking ball",
                        ball(Drag.even(drag, 0, 0.1), 0.99 * MASS, List.of()),
                        d ->
                                areAlike
                                        ? sinking((weight + 0.01 * MASS * Plant.GRAVITY) / drag, d)
                                        : pushed(20, 80, d)),
                hidden,
                new Twins("mass_error", "buoyancy_weight", areAlike),
                1);
    }

    private static Manoeuvre sinking(double speed, Draws draws) {
        return new Manoeuvre(
                still(new Vector3D(0, 0, -10), new Vector3D(0, 0, -speed), draws),
                DURATION,
                RATE,
                List.of(),
                List.of());
    }

    /** What only falls has as much too little mass as it has too much drag. */
    private static Puzzle massOrDrag(Draws draws) {
        boolean areAlike = draws.chance(0.6);
        double factor = draws.between(0.45, 0.8);
        double drag = 0.009;
        double more = drag * (1 / factor - 1);
        HiddenEffect hidden =
                draws.chance(0.5)
                        ? HiddenEffect.of(
                                "mass_error",
                                Map.of("factor", Numbers.of(factor)),
                                r -> r.with(p -> p.withMass(factor * p.mass())))
                        : HiddenEffect.of(
                                "quadratic_drag",
                                Map.of("k", Numbers.of(more)),
                                r -> r.with(p -> p.withDrag(d -> d.withEven(0, more, 0))));
        BallInAir ball = new BallInAir();
        return new Puzzle(
                new Plain(
                        "falling ball",
                        BallInAir.plant(Drag.even(0, drag, 0)),
                        d -> areAlike ? ball.manoeuvre(d) : blown(ball.manoeuvre(d), d)),
                hidden,
                new Twins("quadratic_drag", "mass_error", areAlike),
                1);
    }

    /** Pushed aside while it falls, by about its weight. */
    private static Manoeuvre blown(Manoeuvre of, Draws draws) {
        return new Manoeuvre(
                of.start(),
                of.duration(),
                of.rate(),
                of.commands(),
                new Pushing(1, 3, LEVER).draw(of.duration(), draws));
    }

    /**
     * A body that drifts with the water, or is told to drift. Under linear drag both give the same
     * path if the body sets out faster by the current, so only a start that is known well can tell,
     * and only where the water takes long to take the body along.
     */
    private static Puzzle currentOrDrift(Draws draws) {
        boolean areAlike = draws.chance(0.6);
        Vector3D u = draws.flatDirection().scalarMultiply(draws.between(0.03, 0.06));
        return new Puzzle(
                new Plain(
                        "drifting ball",
                        ball(Drag.even(areAlike ? 60 : 2, 0, 0.1), MASS, List.of()),
                        d -> areAlike ? pushed(4, 40, d) : pushed(1, 10, d)),
                HiddenEffect.of(
                        "current_constant", Map.of("u", Numbers.of(u)), r -> r.in((p, t) -> u)),
                new Twins("current_constant", "position_drift", areAlike),
                areAlike ? 20 : 0.02);
    }
}
