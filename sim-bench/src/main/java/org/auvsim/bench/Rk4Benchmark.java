package org.auvsim.bench;

import org.auvsim.core.dynamics.EquationsOfMotion;
import org.auvsim.core.dynamics.Rk4;
import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BlockEffect;
import org.auvsim.core.entity.Bodies;
import org.auvsim.core.entity.BodyState;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
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

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** An RK4 step of 0.05 s of one body among many, on one thread. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(2)
public class Rk4Benchmark {
    private static final int BODY_STEPS = 64_000;
    private static final double DT = 0.05;

    /** What pushes each body. */
    public enum Load {
        NOTHING,
        /** A named force; the bodies turn. */
        ONE_FORCE,
        /** A named force on bodies that do not turn, as those of the bench's workload. */
        ONE_FORCE_NO_TURN,
        /** Three named forces: in either frame, one of them off the centre. */
        THREE_FORCES,
        /** A named force, weight and damping. */
        THREE_EFFECTS
    }

    @Param({"64", "1000", "100000"})
    int bodies;

    @Param Load load = Load.NOTHING;

    private final Rk4 rk4 = new Rk4();
    private final Block block = new Block();
    private BodyState state = new BodyState();
    private EquationsOfMotion equations = new EquationsOfMotion(state, List.of());
    private double[][] after = new double[0][];
    private int next;

    /** Lays the bodies out. */
    @Setup
    public void build() {
        Bodies world = new Bodies();
        for (int i = 0; i < bodies; i++) {
            world.add(i + 1, definition(i));
        }
        state = world.state();
        after = new double[BodyState.COLUMNS][bodies];
        equations = new EquationsOfMotion(state, effects());
    }

    private WorldObjectDefinition definition(int i) {
        WorldObjectDefinition.Builder body =
                WorldObjectDefinition.named("body " + i)
                        .volume(new Box(new Vec3(1, 0.4, 0.3)))
                        .mass(30)
                        .position(10.0 * i, 0, 0)
                        .velocity(1, 0.1, 0);
        if (load != Load.ONE_FORCE_NO_TURN) {
            body.angularVelocity(0.1, 0.2, 0.3);
        }
        if (load == Load.ONE_FORCE || load == Load.ONE_FORCE_NO_TURN) {
            body.force(new NamedForce("drive", Frame.WORLD, new Vec3(10, 0, 0), Vec3.ZERO));
        }
        if (load == Load.THREE_FORCES || load == Load.THREE_EFFECTS) {
            body.force(new NamedForce("thrust", Frame.BODY, new Vec3(10, 0, 0), Vec3.ZERO));
        }
        if (load == Load.THREE_FORCES) {
            body.force(new NamedForce("weight", Frame.WORLD, new Vec3(0, 0, -3), Vec3.ZERO));
            body.force(
                    new NamedForce("float", Frame.WORLD, new Vec3(0, 0, 3), new Vec3(0, 0, 0.01)));
        }
        return body.build();
    }

    private List<BlockEffect> effects() {
        if (load != Load.THREE_EFFECTS) {
            return List.of();
        }
        Vec3 ones = new Vec3(1, 1, 1);
        return List.of(onAll(new Gravity(9.80665)), onAll(new Damping(ones, ones, ones, ones)));
    }

    private BlockEffect onAll(Effect effect) {
        return effect.layOut(
                new ArrayList<>(Collections.nCopies(bodies, List.of(effect))),
                new Bodies().surroundings());
    }

    /** Copies in, steps, copies out; goes on from where the last call stopped. */
    @Benchmark
    @OperationsPerInvocation(BODY_STEPS)
    public Block step() {
        for (int done = 0; done < BODY_STEPS; done += block.count) {
            int count = Math.min(Block.SIZE, Math.min(bodies - next, BODY_STEPS - done));
            equations.load(block, next, count, 0);
            equations.evaluate(block);
            rk4.advance(equations, block, DT);
            for (int c = 0; c < BodyState.COLUMNS; c++) {
                System.arraycopy(block.state[c], 0, after[c], next, count);
            }
            next = (next + count) % bodies;
        }
        return block;
    }
}
