package org.auvsim.core.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.entity.Effect;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.function.BiFunction;

/** Effects that models most often lack, against their equations, body by body. */
class CandidateEffectsTest {
    private static final Vec3 A = new Vec3(0.7, -0.4, 1.1);
    private static final Vec3 B = new Vec3(-0.2, 0.9, 0.3);

    /** A force (N, world) as an equation tells it. */
    private record Equation(BiFunction<Block, Integer, Vec3> force) implements BodyEffect {
        @Override
        public void add(Block block, int i) {
            block.addForce(i, force.apply(block, i));
        }
    }

    private static void assertIs(
            long seed, Effect effect, BiFunction<Block, Integer, Vec3> equation) {
        BodyByBody.assertSameMotion(
                seed,
                effect,
                new Equation(equation),
                new UniformCurrent(999, "stream", new Vec3(0.5, -0.3, 0.2)));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2})
    void isotropicDrag(long seed) {
        assertIs(
                seed,
                new IsotropicDrag(0.4, 0.7, 0),
                (b, i) -> {
                    Vec3 v = b.velocity(i).minus(b.waterVelocity(i));
                    return v.times(-0.4 - 0.7 * v.norm());
                });
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2})
    void anisotropicDrag(long seed) {
        assertIs(
                seed,
                new AnisotropicDrag(A),
                (b, i) -> {
                    Vec3 v = b.toBody(i, b.velocity(i).minus(b.waterVelocity(i)));
                    return b.toWorld(
                            i,
                            new Vec3(
                                    -A.x() * Math.abs(v.x()) * v.x(),
                                    -A.y() * Math.abs(v.y()) * v.y(),
                                    -A.z() * Math.abs(v.z()) * v.z()));
                });
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2})
    void coulombFriction(long seed) {
        assertIs(
                seed,
                new CoulombFriction(0.2, 9.81, 0.01),
                (b, i) -> {
                    Vec3 v = b.velocity(i);
                    return v.times(-0.2 * b.mass[i] * 9.81 / Math.max(v.norm(), 0.01));
                });
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2})
    void magneticAttraction(long seed) {
        assertIs(
                seed,
                new MagneticAttraction(3, A, 0.5),
                (b, i) -> {
                    Vec3 d = A.minus(b.position(i));
                    double r = Math.max(d.norm(), 0.5);
                    return d.times(3 / (r * r * r * r * r));
                });
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2})
    void periodicForce(long seed) {
        assertIs(
                seed,
                new PeriodicForce(A, B, 7),
                (b, i) ->
                        A.times(StrictMath.sin(7 * b.time))
                                .plus(B.times(StrictMath.cos(7 * b.time))));
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2})
    void waveForce(long seed) {
        Vec3 along = new Vec3(StrictMath.cos(0.6), StrictMath.sin(0.6), 0);
        assertIs(
                seed,
                new WaveForce(1.3, 0.6, 7, 0.4, 0.9),
                (b, i) ->
                        along.times(
                                1.3
                                        * StrictMath.sin(
                                                7 * b.time
                                                        - 0.9 * along.dot(b.position(i))
                                                        + 0.4)));
    }

    /** After it has risen, a force has done what one would that had jumped in the middle. */
    @Test
    void aStepForceActsFromItsTimeOn() {
        World world = world(new StepForce(A, 1.013, 0.15));
        Vec3 velocity = A.times(2.5 - 1.013);
        assertNear(world.object("ball").velocity(), velocity, 1e-12);
        Vec3 way = A.times((2.5 - 1.013) * (2.5 - 1.013) / 2);
        assertThat(world.object("ball").position().distance(way)).isLessThan(1e-3);
    }

    /** Whole, wherever it falls within a time step. */
    @ParameterizedTest
    @ValueSource(doubles = {1, 1.013, 1.025, 1.049})
    void aKickGivesItsImpulse(double at) {
        World world = world(new Kick(A, at, 0.15));
        assertNear(world.object("ball").velocity(), A, 1e-12);
        Vec3 way = A.times(2.5 - at);
        assertThat(world.object("ball").position().distance(way)).isLessThan(1e-3);
    }

    private static World world(Effect effect) {
        World world =
                World.builder()
                        .timeStep(0.05)
                        .add(
                                WorldObjectDefinition.named("ball")
                                        .mass(1)
                                        .volume(new Sphere(0.1))
                                        .effect(effect)
                                        .build())
                        .build();
        for (int step = 0; step < 50; step++) {
            world.advanceTimestep();
        }
        assertThat(world.time()).isCloseTo(2.5, within(1e-12));
        return world;
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2})
    void smoothForcesActAsTheySay(long seed) {
        SmoothForce waves = new WaveForce(1.3, 0.6, 7, 0.4, 0.9);
        SmoothForce ellipse = new PeriodicForce(A, B, 7);

        assertIs(seed, waves, (b, i) -> waves.at(b.position(i), b.time));
        assertIs(seed, ellipse, (b, i) -> ellipse.at(b.position(i), b.time));
    }
}
