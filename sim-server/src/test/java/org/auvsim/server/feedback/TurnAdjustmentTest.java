package org.auvsim.server.feedback;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.document.MomentumRule;
import org.auvsim.auvsml.message.feedback.DifferentOrientationFeedbackMessage;
import org.auvsim.auvsml.message.feedback.DifferentVelocityFeedbackMessage;
import org.auvsim.core.effect.Damping;
import org.auvsim.core.entity.AddedMass;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Random;

/** How vector adjustment meets measured orientations and velocities, by torques as by forces. */
class TurnAdjustmentTest {
    private static final String VECTOR = "VectorAdjustmentFeedbackHandler";
    private static final double STEP = 0.05;
    private static final Vec3 SPIN = new Vec3(0.2, -0.1, 0.6);

    private static WorldObjectDefinition.Builder brick() {
        return WorldObjectDefinition.named("brick")
                .id(1)
                .mass(40)
                .volume(new Box(new Vec3(1.6, 0.4, 0.3)))
                .velocity(1, 0, 0)
                .angularVelocity(SPIN.x(), SPIN.y(), SPIN.z());
    }

    private static World world(WorldObjectDefinition.Builder body) {
        return World.builder().timeStep(STEP).add(body.build()).build();
    }

    private static StepRecord corrected(World world, MomentumRule rule) {
        return new StepRecord(
                world,
                SimpleFixedTimeFeedbackTimestepper.waiting(Duration.ofMillis(1)),
                new VectorAdjustmentFeedbackHandler(rule));
    }

    private static void turned(StepRecord step, double time, Quat orientation) {
        step.send(
                new DifferentOrientationFeedbackMessage(
                        1, time, VECTOR, Optional.empty(), orientation));
    }

    private static RigidMotion uncorrected(World world) {
        World alone = world.copy();
        alone.advanceTimestep();
        return RigidMotion.of(alone.object(1));
    }

    @Test
    void orientationIsMetAndAllElseIsTheModels() {
        World world = world(brick());
        RigidMotion alone = uncorrected(world);
        Quat measured = Turns.of(new Vec3(0.05, 0.2, -0.1)).times(alone.orientation());
        StepRecord step = corrected(world, MomentumRule.PROJECTED);
        step.robot(p -> turned(step, p.time(), measured));
        step.advanceTimestep();
        RigidMotion end = RigidMotion.of(world.object(1));
        assertThat(Turns.between(measured, end.orientation()).norm()).isLessThan(1e-9);
        assertThat(end.angularVelocity().distance(alone.angularVelocity())).isLessThan(1e-7);
        assertThat(end.position().distance(alone.position())).isLessThan(1e-12);
        assertThat(end.velocity().distance(alone.velocity())).isLessThan(1e-12);
        assertThat(world.object(1).forces()).isEmpty();
        AppliedFeedback applied = step.applied.getFirst();
        assertThat(applied.converged()).isTrue();
        assertThat(applied.before().position()).isEmpty();
        assertThat(applied.before().angle().orElseThrow()).isCloseTo(0.229, within(1e-3));
        assertThat(applied.after().angle().orElseThrow()).isLessThan(1e-9);
    }

    /** A vehicle that couples all its motions: water that it carries, and damping. */
    @Test
    void aFullStateIsMetThroughWater() {
        AddedMass water = new AddedMass(new Vec3(2, 60, 70), new Vec3(0.1, 6, 6), List.of());
        World world =
                world(
                        brick().addedMass(water)
                                .effect(
                                        new Damping(
                                                new Vec3(5, 40, 40),
                                                new Vec3(20, 200, 200),
                                                new Vec3(1, 10, 10),
                                                new Vec3(2, 20, 20))));
        RigidMotion goal =
                uncorrected(world)
                        .plus(
                                new double[] {
                                    0.02, -0.03, 0.01, 0.02, 0.05, -0.04, 0.1, 0, 0.05, 0.1, -0.1, 0
                                });
        StepRecord step = corrected(world, MomentumRule.PROJECTED);
        step.robot(p -> step.send(Messages.state(p.time(), VECTOR, goal)));
        step.advanceTimestep();
        double[] miss = RigidMotion.of(world.object(1)).minus(goal);
        assertThat(step.applied.getFirst().converged()).isTrue();
        for (double part : miss) {
            assertThat(part).isCloseTo(0, within(1e-7));
        }
    }

    @Test
    void aVelocityAloneIsMetAndThePlaceStaysTheModels() {
        World world = world(brick());
        RigidMotion alone = uncorrected(world);
        Vec3 measured = new Vec3(1.2, -0.3, 0.1);
        StepRecord step = corrected(world, MomentumRule.PROJECTED);
        step.robot(
                p ->
                        step.send(
                                new DifferentVelocityFeedbackMessage(
                                        1,
                                        p.time(),
                                        VECTOR,
                                        Optional.empty(),
                                        measured,
                                        Optional.empty())));
        step.advanceTimestep();
        RigidMotion end = RigidMotion.of(world.object(1));
        assertThat(end.velocity().distance(measured)).isLessThan(1e-7);
        assertThat(end.position().distance(alone.position())).isLessThan(1e-9);
    }

    /**
     * A noise of 0.01 rad at every step: one torque rings as one force does, its errors of the
     * spin, each 2 (e - last)/dt minus the last one, never die out; two torques leave the spin
     * alone.
     */
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void noisyOrientationsRingAsInTheThesisAndNotByDefault(long seed) {
        assertThat(fastest(MomentumRule.AS_THESIS, seed)).isBetween(3.0, 60.0);
        assertThat(fastest(MomentumRule.PROJECTED, seed)).isLessThan(1e-6);
    }

    /** The largest error of the spin (rad/s) of a ball-like body that spins about z, in 5 s. */
    private static double fastest(MomentumRule rule, long seed) {
        Vec3 spin = new Vec3(0, 0, 0.5);
        World world =
                World.builder()
                        .timeStep(STEP)
                        .add(
                                WorldObjectDefinition.named("cube")
                                        .id(1)
                                        .mass(3)
                                        .volume(new Box(new Vec3(1, 1, 1)))
                                        .angularVelocity(0, 0, 0.5)
                                        .build())
                        .build();
        StepRecord step = corrected(world, rule);
        Random noise = new Random(seed);
        step.robot(
                p -> {
                    double angle = 0.5 * p.time() + 0.01 * noise.nextGaussian();
                    turned(step, p.time(), Quat.ofAxisAngle(new Vec3(0, 0, 1), angle));
                });
        double fastest = 0;
        while (world.time() < 5) {
            step.advanceTimestep();
            fastest = Math.max(fastest, world.object(1).angularVelocity().distance(spin));
        }
        assertThat(step.applied).allSatisfy(a -> assertThat(a.converged()).isTrue());
        return fastest;
    }

    /** Behind a wall there is no way: the object gets as near as it can, and says so. */
    @Test
    void whatCannotBeMetIsSaid() {
        World world = world(brick());
        world.add(
                WorldObjectDefinition.named("wall")
                        .id(2)
                        .fixed()
                        .volume(new Box(new Vec3(1, 20, 20)))
                        .position(1.6, 0, 0)
                        .build());
        StepRecord step = corrected(world, MomentumRule.PROJECTED);
        step.robot(p -> step.send(1, p.time(), VECTOR, new Vec3(1.5, 0, 0)));
        step.advanceTimestep();
        AppliedFeedback applied = step.applied.getFirst();
        assertThat(applied.converged()).isFalse();
        assertThat(step.errorAfter(0)).isBetween(1.0, 1.45);
        assertThat(world.object(1).position().x()).isLessThan(0.4);
    }
}
