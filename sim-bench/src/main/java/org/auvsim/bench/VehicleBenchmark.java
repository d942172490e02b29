package org.auvsim.bench;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.dynamics.EquationsOfMotion;
import org.auvsim.core.dynamics.Rk4;
import org.auvsim.core.effect.Buoyancy;
import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.DampingTerm;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.AddedMass;
import org.auvsim.core.entity.AddedMassTerm;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.Bodies;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.MotionAxis;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldBuilder;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.TimeUnit;

/**
 * A step of 0.05 s of one of a hundred vehicles on which six effects act: weight, buoyancy, damping
 * with elements beside the diagonal, added mass, a propulsor and a current.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(2)
public class VehicleBenchmark {
    private static final int VEHICLES = 100;
    private static final double DT = 0.05;
    private static final UniformCurrent TIDE =
            new UniformCurrent(1000, "tide", new Vec3(0.3, 0.1, 0));
    private static final List<Effect> EFFECTS =
            List.of(
                    new Gravity(9.80665),
                    new Buoyancy(
                            0.03, 1025, 9.80665, new Vec3(0, 0, 0.02), 0, OptionalDouble.empty()),
                    new Damping(
                            new Vec3(2, 20, 20),
                            new Vec3(2, 130, 130),
                            new Vec3(0.2, 5, 5),
                            new Vec3(0.1, 10, 10),
                            List.of(
                                    new DampingTerm(MotionAxis.SWAY, MotionAxis.YAW, 1, 0),
                                    new DampingTerm(MotionAxis.YAW, MotionAxis.SWAY, 1, 0),
                                    new DampingTerm(MotionAxis.HEAVE, MotionAxis.PITCH, -1, 0),
                                    new DampingTerm(MotionAxis.PITCH, MotionAxis.HEAVE, -1, 0))));
    private static final AddedMass WATER =
            new AddedMass(
                    new Vec3(0.93, 35.5, 35.5),
                    new Vec3(0.07, 4.88, 4.88),
                    List.of(
                            new AddedMassTerm(MotionAxis.SWAY, MotionAxis.YAW, -1.93),
                            new AddedMassTerm(MotionAxis.HEAVE, MotionAxis.PITCH, 1.93)));

    /** Lag of the propulsors (s): none, so that they push constantly, or one that never ends. */
    @Param({"0", "1000"})
    public double lag;

    private final Rk4 rk4 = new Rk4();
    private final Block block = new Block();
    private final Bodies bodies = new Bodies();
    private World world = World.builder().build();
    private EquationsOfMotion equations = new EquationsOfMotion(bodies.state(), List.of());

    /** Lays the vehicles out, 20 m apart. */
    @Setup
    public void build() {
        WorldBuilder builder = World.builder().timeStep(DT).add(TIDE);
        for (int i = 0; i < VEHICLES; i++) {
            bodies.add(i + 1, vehicle(i));
            builder.add(vehicle(i));
        }
        world = builder.build();
        bodies.state().setFields(List.of(TIDE));
        equations =
                new EquationsOfMotion(
                        bodies.state(),
                        EFFECTS.stream()
                                .map(
                                        effect ->
                                                effect.layOut(
                                                        Collections.nCopies(
                                                                VEHICLES, List.of(effect)),
                                                        bodies.surroundings()))
                                .toList());
        bodies.objects().forEach(vehicle -> vehicle.command(Propulsor.class, "Propeller", 0.6));
        world.objects().forEach(vehicle -> vehicle.command(Propulsor.class, "Propeller", 0.6));
    }

    private WorldObjectDefinition vehicle(int i) {
        WorldObjectDefinition.Builder vehicle =
                WorldObjectDefinition.named("vehicle " + i)
                        .volume(new Box(new Vec3(1.3, 0.2, 0.2)))
                        .mass(30.5)
                        .addedMass(WATER)
                        .position(20.0 * (i % 10), 20.0 * Math.floorDiv(i, 10), -20)
                        .velocity(1, 0, 0)
                        .component(propeller());
        EFFECTS.forEach(vehicle::effect);
        return vehicle.build();
    }

    private Propulsor propeller() {
        return new Propulsor(
                "Propeller",
                10,
                0,
                new Vec3(-0.6, 0, 0),
                new Vec3(1, 0, 0),
                Optional.empty(),
                lag,
                0,
                0,
                0,
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty());
    }

    /** Integration alone: copies in, integrates, copies out. */
    @Benchmark
    @OperationsPerInvocation(VEHICLES)
    public double integrate() {
        equations.load(block, 0, VEHICLES, 0);
        equations.evaluate(block);
        rk4.advance(equations, block, DT);
        for (int c = 0; c < block.state.length; c++) {
            block.scatter(block.state[c], bodies.state().column(c));
        }
        return block.time;
    }

    /** A whole step of their world, collisions looked for. */
    @Benchmark
    @OperationsPerInvocation(VEHICLES)
    public double step() {
        return world.advanceTimestep();
    }
}
