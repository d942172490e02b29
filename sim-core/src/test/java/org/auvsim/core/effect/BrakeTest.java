package org.auvsim.core.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class BrakeTest {
    private static final Vec3 TORQUE = new Vec3(0.5, 1, 1.5);

    /** As the comment of Brake says it. */
    private record Slow(Brake brake) implements BodyEffect {
        @Override
        public void add(Block block, int i) {
            Vec3 v = block.velocity(i);
            Vec3 w = block.toBody(i, block.angularVelocity(i));
            double rate = Math.max(w.norm(), brake.slipRate());
            Vec3 t = brake.torque();
            block.addForce(i, v.times(-brake.force() / Math.max(v.norm(), brake.slipSpeed())));
            block.addTorque(
                    i,
                    block.toWorld(
                            i,
                            new Vec3(t.x() * w.x(), t.y() * w.y(), t.z() * w.z())
                                    .times(-1 / rate)));
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void worksAgainstTheMotion(long seed) {
        Brake brake = new Brake(3, new Vec3(0.2, 0.3, 0.4), 0.5, 0.4);
        BodyByBody.assertSameMotion(seed, brake, new Slow(brake));
    }

    /** v = v0 - f t / m while it slips, and rest soon after t = m v0 / f. */
    @Test
    void aBodyStopsAfterTheTimeThatItsMomentumTakes() {
        World world = world();
        advance(world, 3);
        assertThat(world.object("body").velocity().norm())
                .isCloseTo(5 - 1.25 * world.time(), within(1e-9));
        assertThat(world.object("body").angularVelocity().norm())
                .isCloseTo(2 - 0.5 * world.time(), within(1e-9));
        advance(world, 8);
        assertThat(world.object("body").velocity().norm()).isLessThan(1e-12);
        assertThat(world.object("body").angularVelocity().norm()).isLessThan(1e-12);
    }

    @Test
    void aSmallForceMakesItCreep() {
        World world = world();
        world.object("body")
                .applyForce(NamedForce.direct("drift", Frame.WORLD, new Vec3(0, 0, -1)));
        advance(world, 12);
        assertThat(world.object("body").velocity().z()).isCloseTo(-0.05 / 5, within(1e-9));
    }

    private static World world() {
        return World.builder()
                .timeStep(0.01)
                .add(
                        WorldObjectDefinition.named("body")
                                .volume(new Sphere(0.5))
                                .mass(4)
                                .inertia(new Inertia(1, 2, 3, 0, 0, 0))
                                .velocity(3, 4, 0)
                                .angularVelocity(0, 2, 0)
                                .effect(new Brake(5, TORQUE, 0.05, 0.05))
                                .build())
                .build();
    }

    private static void advance(World world, double until) {
        while (world.time() < until - 1e-9) {
            world.advanceTimestep();
        }
    }

    @ParameterizedTest
    @CsvSource({
        "-1, 0, 1, 1, the force of a brake must be 0 N or more",
        "1, NaN, 1, 1, the torque about x of a brake must be 0 N m or more",
        "1, 0, 0, 1, the slip speed of a brake must be above 0 m/s",
        "1, 0, 1, 0, the slip rate of a brake must be above 0 rad/s"
    })
    void numbersThatMeanNothingAreRefused(
            double force, double torque, double slipSpeed, double slipRate, String message) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Brake(force, new Vec3(torque, 0, 0), slipSpeed, slipRate))
                .withMessageStartingWith(message);
    }
}
