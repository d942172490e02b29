package org.auvsim.core.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.entity.Inertia;
import org.auvsim.core.entity.Pinned;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Optional;

class PivotFrictionTest {
    private static final double INERTIA = 2;

    private record Rub(PivotFriction f) implements BodyEffect {
        @Override
        public void add(Block block, int i) {
            Vec3 w = block.angularVelocity(i);
            double size = f.coulomb() * Math.min(1, w.norm() / f.slipRate());
            Vec3 coulomb = w.norm() > 0 ? w.times(-size / w.norm()) : Vec3.ZERO;
            block.addTorque(i, coulomb.minus(w.times(f.viscous())));
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void worksAgainstTheTurning(long seed) {
        PivotFriction friction = new PivotFriction(0.8, 0.3, 0.5);
        BodyByBody.assertSameMotion(seed, friction, new Rub(friction));
    }

    /** I w' = -T - c w: w = (w0 + T/c) exp(-c t/I) - T/c while it slips. */
    @Test
    void aFlywheelSlowsDownAsItsEquationSays() {
        World world = flywheel(new PivotFriction(1.2, 0.5, 0.01));
        while (world.time() < 3) {
            world.advanceTimestep();
        }
        double expected = (5 + 2.4) * StrictMath.exp(-0.25 * world.time()) - 2.4;
        assertThat(rate(world)).isCloseTo(expected, within(1e-8));
    }

    /** Coulomb friction alone stops it at t = I w0 / T, where viscous friction never would. */
    @Test
    void coulombFrictionStopsAFlywheelInAFiniteTime() {
        World world = flywheel(new PivotFriction(4, 0, 0.02));
        while (world.time() < 2) {
            world.advanceTimestep();
        }
        assertThat(rate(world)).isCloseTo(5 - 2 * world.time(), within(1e-8));
        while (world.time() < 2.6) {
            world.advanceTimestep();
        }
        assertThat(rate(world)).isBetween(0.0, 1e-4);
    }

    private static World flywheel(PivotFriction friction) {
        return World.builder()
                .timeStep(0.01)
                .add(
                        WorldObjectDefinition.named("flywheel")
                                .volume(new Sphere(0.5))
                                .mass(10)
                                .inertia(new Inertia(1, 1, INERTIA, 0, 0, 0))
                                .mount(new Pinned(Optional.of(new Vec3(0, 0, 1))))
                                .angularVelocity(0, 0, 5)
                                .effect(friction)
                                .build())
                .build();
    }

    private static double rate(World world) {
        return world.object("flywheel").angularVelocity().z();
    }

    @ParameterizedTest
    @CsvSource({
        "-1, 0, 1, the coulomb torque of a pivot friction must be 0 N m or more",
        "0, NaN, 1, the viscous coefficient of a pivot friction must be 0 N m s/rad or more",
        "0, 0, 0, the slip rate of a pivot friction must be above 0 rad/s"
    })
    void numbersThatMeanNothingAreRefused(
            double coulomb, double viscous, double slipRate, String message) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new PivotFriction(coulomb, viscous, slipRate))
                .withMessageStartingWith(message);
    }
}
