package org.auvsim.core.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.auvsim.core.math.Near.assertNear;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class MagnusForceTest {
    private record Lift(double c) implements BodyEffect {
        @Override
        public void add(Block block, int i) {
            Vec3 through = block.velocity(i).minus(block.waterVelocity(i));
            block.addForce(i, block.angularVelocity(i).cross(through).times(c));
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void isAsItsEquationSays(long seed) {
        BodyByBody.assertSameMotion(
                seed,
                new MagnusForce(0.7),
                new Lift(0.7),
                new UniformCurrent(999, "stream", new Vec3(0.5, -0.3, 0.2)));
    }

    /**
     * With a constant spin w the velocity turns at c w / m, and the path is a circle, however far
     * the ball turns in a step. It does so about no axis of its own.
     */
    @ParameterizedTest
    @ValueSource(doubles = {4, 100})
    void aSpinningBallFliesACircle(double spin) {
        double rate = 1;
        World world =
                World.builder()
                        .timeStep(0.01)
                        .add(
                                WorldObjectDefinition.named("ball")
                                        .volume(new Sphere(0.1))
                                        .mass(2)
                                        .orientation(Quat.ofAxisAngle(new Vec3(1, 0, 0), 1))
                                        .velocity(3, 0, 0)
                                        .angularVelocity(0, 0, spin)
                                        .effect(new MagnusForce(rate * 2 / spin))
                                        .build())
                        .build();
        while (world.time() < 4) {
            world.advanceTimestep();
        }
        double angle = rate * world.time();
        Vec3 expected = new Vec3(StrictMath.sin(angle), 1 - StrictMath.cos(angle), 0);
        assertNear(world.object("ball").position(), expected.times(3 / rate), 1e-7);
        assertThat(angle).isGreaterThan(3.9);
    }

    @Test
    void aCoefficientThatIsNotFiniteIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new MagnusForce(Double.NaN))
                .withMessage("the coefficient of a Magnus force must be finite, but is NaN kg");
    }
}
