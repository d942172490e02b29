package org.auvsim.core.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.Block;
import org.auvsim.core.entity.BodyEffect;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;

class HydrodynamicDerivativesTest {
    /** Body lift and cross-flow of a torpedo, as printed, beside some of every other form. */
    private static final HydrodynamicDerivatives PRINTED =
            new HydrodynamicDerivatives(
                    ReferenceAxes.FRD,
                    List.of(
                            new Derivative("Xu|u|", -1.62),
                            new Derivative("Yv|v|", -131),
                            new Derivative("Yuv", -28.6),
                            new Derivative("Zuw", -28.6),
                            new Derivative("Zq|q|", -0.632),
                            new Derivative("Kp", -0.3),
                            new Derivative("Muw", -10.62),
                            new Derivative("Nuv", 10.62),
                            new Derivative("Nv|r|", 0.7)));

    /** The same written out in forward, right, down. */
    private record Torpedo() implements BodyEffect {
        @Override
        public void add(Block block, int i) {
            Vec3 v = turned(block.toBody(i, block.velocity(i).minus(block.waterVelocity(i))));
            Vec3 w = turned(block.bodyAngularVelocity(i));
            double across = v.y();
            Vec3 force =
                    new Vec3(
                            -1.62 * v.x() * Math.abs(v.x()),
                            -131 * across * Math.abs(across) - 28.6 * v.x() * across,
                            -28.6 * v.x() * v.z() - 0.632 * w.y() * Math.abs(w.y()));
            Vec3 torque =
                    new Vec3(
                            -0.3 * w.x(),
                            -10.62 * v.x() * v.z(),
                            10.62 * v.x() * across + 0.7 * across * Math.abs(w.z()));
            block.addForce(i, block.toWorld(i, turned(force)));
            block.addTorque(i, block.toWorld(i, turned(torque)));
        }

        /** From forward, left, up to forward, right, down, and back. */
        private static Vec3 turned(Vec3 v) {
            return new Vec3(v.x(), -v.y(), -v.z());
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void printedDerivativesActAsTheirNamesSay(long seed) {
        BodyByBody.assertSameMotion(
                seed,
                PRINTED,
                new Torpedo(),
                new UniformCurrent(999, "stream", new Vec3(0.5, -0.3, 0.2)));
    }

    /** m v' = -k v^2 has the speed v0 / (1 + k v0 t / m). */
    @Test
    void surgeDragStopsABodyAsItsEquationSays() {
        World world = World.builder().timeStep(0.01).add(swimmer("Xu|u|", -4)).build();
        while (world.time() < 5) {
            world.advanceTimestep();
        }
        WorldObject body = world.object("swimmer");
        assertThat(body.velocity().x())
                .isCloseTo(2 / (1 + 4 * 2 * world.time() / 10), within(1e-8));
    }

    /** In the simulator's own axes a force to port is positive. */
    @ParameterizedTest
    @CsvSource({"FLU, 1", "FRD, 1", "FLU, -1"})
    void aLinearForceOfSwayBySwayHasItsOwnSignInAnyAxes(ReferenceAxes axes, double k) {
        World world =
                World.builder()
                        .timeStep(0.01)
                        .add(
                                body().velocity(0, 1, 0)
                                        .effect(of(axes, new Derivative("Yv", k)))
                                        .build())
                        .build();
        world.advanceTimestep();
        assertThat(world.object("swimmer").velocity().y())
                .isCloseTo(StrictMath.exp(k * world.time() / 10), within(1e-12));
    }

    @ParameterizedTest
    @CsvSource({"FLU, 1", "FRD, -1"})
    void aYawTorqueBySwayAndSurgeTurnsToThePortSideOfItsAxes(ReferenceAxes axes, double sign) {
        World world =
                World.builder()
                        .timeStep(0.001)
                        .add(
                                body().velocity(1, 1, 0)
                                        .effect(of(axes, new Derivative("Nu|v|", 2)))
                                        .build())
                        .build();
        world.advanceTimestep();
        assertThat(Math.signum(world.object("swimmer").angularVelocity().z())).isEqualTo(sign);
    }

    private static WorldObjectDefinition swimmer(String name, double value) {
        return body().velocity(2, 0, 0)
                .effect(of(ReferenceAxes.FLU, new Derivative(name, value)))
                .build();
    }

    private static WorldObjectDefinition.Builder body() {
        return WorldObjectDefinition.named("swimmer").volume(new Sphere(0.5)).mass(10);
    }

    private static HydrodynamicDerivatives of(ReferenceAxes axes, Derivative derivative) {
        return new HydrodynamicDerivatives(axes, List.of(derivative));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "Y", "Yvdot", "Yuudr", "yv", "Y|v|v", "Yvvv", "Av", "Yx"})
    void otherNamesAreRefusedWithExamples(String name) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Derivative(name, 1))
                .withMessageContaining("Yv|v|, Nuv or Zq")
                .withMessageContaining("'" + name + "' is not");
    }

    @Test
    void productsAreTheSameInEitherOrder() {
        assertThatIllegalArgumentException()
                .isThrownBy(
                        () ->
                                new HydrodynamicDerivatives(
                                        ReferenceAxes.FLU,
                                        List.of(
                                                new Derivative("Nuv", 1),
                                                new Derivative("Nvu", 2))))
                .withMessage(
                        "the hydrodynamic derivatives Nuv (1.0) and Nvu (2.0) are one term that"
                                + " is stated twice; leave one of them");
        List<Derivative> different =
                List.of(
                        new Derivative("Nu|v|", 1),
                        new Derivative("Nv|u|", 1),
                        new Derivative("Nuv", 1));
        assertThat(new HydrodynamicDerivatives(ReferenceAxes.FLU, different).derivative())
                .hasSize(3);
    }

    @Test
    void thereMustBeSome() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new HydrodynamicDerivatives(ReferenceAxes.FLU, List.of()))
                .withMessage(
                        "the list of hydrodynamic derivatives must have at least one, but has 0");
    }

    @Test
    void aDerivativeIsFiniteAndStatedOnce() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Derivative("Yv", Double.NaN))
                .withMessage("the Yv of a hydrodynamic derivative must be finite, but is NaN");
        assertThatIllegalArgumentException()
                .isThrownBy(
                        () ->
                                new HydrodynamicDerivatives(
                                        ReferenceAxes.FLU,
                                        List.of(new Derivative("Yv", 1), new Derivative("Yv", 2))))
                .withMessage(
                        "the hydrodynamic derivatives Yv (1.0) and Yv (2.0) are one term that is"
                                + " stated twice; leave one of them");
    }
}
