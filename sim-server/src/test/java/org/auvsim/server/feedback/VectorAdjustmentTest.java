package org.auvsim.server.feedback;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.document.MomentumRule;
import org.auvsim.core.effect.Damping;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** How vector adjustment meets a measured position, and what it leaves behind. */
class VectorAdjustmentTest {
    private static final String VECTOR = "VectorAdjustmentFeedbackHandler";
    private static final double STEP = 0.05;

    private static World drifting() {
        return World.builder()
                .timeStep(STEP)
                .add(
                        WorldObjectDefinition.named("ship")
                                .id(1)
                                .mass(3)
                                .volume(new Sphere(1))
                                .velocity(1, 0, 0)
                                .build())
                .build();
    }

    private static StepRecord corrected(World world, MomentumRule rule) {
        return new StepRecord(
                world,
                SimpleFixedTimeFeedbackTimestepper.waiting(Duration.ofMillis(1)),
                new VectorAdjustmentFeedbackHandler(rule));
    }

    @Test
    void positionIsMetAndMomentumIsTheProjectedOne() {
        World world = drifting();
        StepRecord step = corrected(world, MomentumRule.PROJECTED);
        step.robot(p -> step.send(1, p.time(), VECTOR, new Vec3(0.04, 0.01, 0)));
        step.advanceTimestep();
        assertThat(world.object(1).position().distance(new Vec3(0.04, 0.01, 0))).isLessThan(1e-9);
        assertThat(world.object(1).linearMomentum().distance(new Vec3(3, 0, 0))).isLessThan(1e-6);
    }

    /** Thesis.md: one constant force leaves a velocity error of 2 (Q - S_P)/dt. */
    @Test
    void oneConstantForceLeavesTwiceTheErrorOverTheStepAsVelocity() {
        World world = drifting();
        StepRecord step = corrected(world, MomentumRule.AS_THESIS);
        step.robot(p -> step.send(1, p.time(), VECTOR, new Vec3(STEP, 0.01, 0)));
        step.advanceTimestep();
        assertThat(world.object(1).position().distance(new Vec3(STEP, 0.01, 0))).isLessThan(1e-9);
        assertThat(world.object(1).velocity().y()).isCloseTo(2 * 0.01 / STEP, within(1e-6));
    }

    @Test
    void positionIsMetThroughStrongQuadraticDamping() {
        World world = drifting();
        World damped =
                World.builder()
                        .timeStep(STEP)
                        .add(
                                WorldObjectDefinition.named("ship")
                                        .id(1)
                                        .mass(3)
                                        .volume(new Sphere(1))
                                        .velocity(1, 0, 0)
                                        .effect(damping())
                                        .build())
                        .build();
        StepRecord step = corrected(damped, MomentumRule.PROJECTED);
        Vec3 measured = new Vec3(0.1, -0.05, 0.02);
        step.robot(p -> step.send(1, p.time(), VECTOR, measured));
        step.advanceTimestep();
        assertThat(damped.object(1).position().distance(measured)).isLessThan(1e-8);
        assertThat(step.errorAfter(0)).isLessThan(1e-8);
        assertThat(damped.object(1).velocity().distance(world.object(1).velocity()))
                .isLessThan(0.5);
    }

    /**
     * 1 cm of noise at every step of 0.05 s: the single force rings, its velocity errors, each 2 (e
     * - last)/dt minus the last one, never die out; two forces leave the momentum alone.
     */
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void noisyFeedbackRingsAsInTheThesisAndNotByDefault(long seed) {
        double ringing = fastest(MomentumRule.AS_THESIS, seed);
        double quiet = fastest(MomentumRule.PROJECTED, seed);
        assertThat(ringing).isBetween(3.0, 60.0);
        assertThat(quiet).isLessThan(1e-9);
    }

    /** The largest velocity error (m/s) of an object that measures itself with noise, in 10 s. */
    private static double fastest(MomentumRule rule, long seed) {
        World world = drifting();
        StepRecord step = corrected(world, rule);
        Random noise = new Random(seed);
        step.robot(
                p ->
                        step.send(
                                1,
                                p.time(),
                                VECTOR,
                                new Vec3(p.time(), 0.01 * noise.nextGaussian(), 0)));
        List<Double> errors = new ArrayList<>();
        while (world.time() < 10) {
            step.advanceTimestep();
            errors.add(world.object(1).velocity().distance(new Vec3(1, 0, 0)));
        }
        assertThat(step.applied)
                .allSatisfy(a -> assertThat(a.after().position().orElseThrow()).isLessThan(1e-7));
        return errors.stream().mapToDouble(e -> e).max().orElseThrow();
    }

    /** A robot that says it is behind a wall does not get its object through the wall. */
    @ParameterizedTest
    @ValueSource(strings = {"PROJECTED", "AS_THESIS"})
    void aWallIsRespected(MomentumRule rule) {
        World world = drifting();
        world.add(
                WorldObjectDefinition.named("wall")
                        .id(2)
                        .fixed()
                        .volume(new Sphere(1))
                        .position(2.5, 0, 0)
                        .build());
        StepRecord step = corrected(world, rule);
        step.robot(p -> step.send(1, p.time(), VECTOR, new Vec3(1.5, 0, 0)));
        step.advanceTimestep();
        AppliedFeedback applied = step.applied.getFirst();
        assertThat(world.object(1).position().x()).isBetween(STEP, 0.5 + 1e-6);
        assertThat(applied.after().position().orElseThrow())
                .isLessThan(applied.before().position().orElseThrow())
                .isGreaterThan(0.9);
    }

    @Test
    void aFixedObjectCannotBePushed() {
        World world =
                World.builder()
                        .add(
                                WorldObjectDefinition.named("pier")
                                        .id(1)
                                        .fixed()
                                        .volume(new Sphere(1))
                                        .build())
                        .build();
        StepRecord step = corrected(world, MomentumRule.PROJECTED);
        step.robot(p -> step.send(1, p.time(), VECTOR, new Vec3(1, 0, 0)));
        step.advanceTimestep();
        assertThat(step.applied).isEmpty();
        assertThat(step.refused)
                .extracting(Throwable::getMessage)
                .containsExactly("'pier' is fixed, and stays where it is whatever is measured");
    }

    @Test
    void aWaitIsNotNegative() {
        assertThatThrownBy(() -> SimpleFixedTimeFeedbackTimestepper.waiting(Duration.ofMillis(-1)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("must be 0 s or more");
    }

    private static Damping damping() {
        return new Damping(new Vec3(2, 2, 2), new Vec3(20, 20, 20), Vec3.ZERO, Vec3.ZERO);
    }
}
