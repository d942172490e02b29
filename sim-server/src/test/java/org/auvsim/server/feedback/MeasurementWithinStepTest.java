package org.auvsim.server.feedback;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.auvsml.message.feedback.DifferentPositionFeedbackMessage;
import org.auvsim.auvsml.message.feedback.DifferentVelocityFeedbackMessage;
import org.auvsim.auvsml.message.feedback.FeedbackAppliedNotification;
import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.auvsml.message.feedback.MeasurementFrame;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.time.Duration;
import java.util.Optional;

/** Measurements at times between two steps, and more than one a step. */
class MeasurementWithinStepTest {
    private static final double STEP = 0.2;
    private static final String DIRECT = "DirectPositionChangeFeedbackHandler";

    /** Accelerates by 3 m/s^2 to the east from 1 m/s. */
    private final World world =
            World.builder()
                    .timeStep(STEP)
                    .add(
                            WorldObjectDefinition.named("ship")
                                    .id(1)
                                    .mass(2)
                                    .volume(new Sphere(1))
                                    .velocity(1, 0, 0)
                                    .orientation(Quat.ofAxisAngle(new Vec3(0, 0, 1), Math.PI / 2))
                                    .force(
                                            NamedForce.direct(
                                                    "engine", Frame.WORLD, new Vec3(6, 0, 0)))
                                    .build())
                    .build();

    private final StepRecord step =
            new StepRecord(world, SimpleFixedTimeFeedbackTimestepper.waiting(Duration.ofMillis(1)));

    private static Vec3 model(double t) {
        return new Vec3(t + 1.5 * t * t, 0, 0);
    }

    private static FeedbackMessage position(
            double time, String handler, MeasurementFrame frame, Vec3 position) {
        return new DifferentPositionFeedbackMessage(
                1, time, handler, Optional.of(frame), Vec3.ZERO, position, Vec3.ZERO);
    }

    @ParameterizedTest
    @ValueSource(strings = {DIRECT, "VectorAdjustmentFeedbackHandler"})
    void theModelsMotionFromThereOnIsAdded(String handler) {
        Vec3 off = new Vec3(0.01, -0.02, 0.03);
        step.robot(
                _ ->
                        step.send(
                                position(
                                        0.07,
                                        handler,
                                        MeasurementFrame.WORLD,
                                        model(0.07).plus(off))));
        step.advanceTimestep();
        assertThat(step.refused).isEmpty();
        assertThat(world.object(1).position().distance(model(STEP).plus(off))).isLessThan(1e-9);
        assertThat(step.errorBefore(0)).isCloseTo(off.norm(), within(1e-12));
    }

    @Test
    void aVelocityWithinTheStepIsCarriedToo() {
        step.robot(
                _ ->
                        step.send(
                                new DifferentVelocityFeedbackMessage(
                                        1,
                                        0.1,
                                        DIRECT,
                                        Optional.empty(),
                                        new Vec3(1.3, 0.5, 0),
                                        Optional.empty())));
        step.advanceTimestep();
        assertThat(world.object(1).velocity().distance(new Vec3(1.6, 0.5, 0))).isLessThan(1e-12);
        assertThat(step.applied.getFirst().notification().measuredPosition()).isEmpty();
    }

    /** Ahead of an object whose nose points to the north. */
    @Test
    void aPlaceInBodyAxesIsAnOffsetFromTheModelAtThatTime() {
        step.robot(
                _ -> step.send(position(0.1, DIRECT, MeasurementFrame.BODY, new Vec3(0.5, 0, 0))));
        step.advanceTimestep();
        Vec3 expected = model(STEP).plus(new Vec3(0, 0.5, 0));
        assertThat(world.object(1).position().distance(expected)).isLessThan(1e-12);
        FeedbackAppliedNotification told = step.applied.getFirst().notification();
        assertThat(told.timestamp()).isEqualTo(STEP);
        assertThat(told.measuredPosition().orElseThrow().distance(expected)).isLessThan(1e-12);
    }

    /** Each has the model's own motion since its time added, not that of corrections before it. */
    @Test
    void measurementsFasterThanTheStepAreUsedInOrder() {
        step.robot(
                _ -> {
                    Vec3 last = model(0.15).plus(new Vec3(0, 0.3, 0));
                    step.send(position(0.15, DIRECT, MeasurementFrame.WORLD, last));
                    step.send(position(0.05, DIRECT, MeasurementFrame.WORLD, model(0.05)));
                    Vec3 second = model(0.1).plus(new Vec3(0, 0.1, 0));
                    step.send(position(0.1, DIRECT, MeasurementFrame.WORLD, second));
                });
        step.advanceTimestep();
        assertThat(step.applied).hasSize(3);
        assertThat(step.errorBefore(0)).isCloseTo(0, within(1e-12));
        assertThat(step.errorBefore(1)).isCloseTo(0.1, within(1e-12));
        assertThat(step.errorBefore(2)).isCloseTo(0.2, within(1e-12));
        assertThat(world.object(1).position().distance(model(STEP).plus(new Vec3(0, 0.3, 0))))
                .isLessThan(1e-12);
    }

    @Test
    void theStepsBeginningBelongsToTheStepBefore() {
        step.robot(
                p -> {
                    if (p.time() < 0.3) {
                        return;
                    }
                    assertThatThrownBy(
                                    () ->
                                            step.send(
                                                    position(
                                                            STEP,
                                                            DIRECT,
                                                            MeasurementFrame.WORLD,
                                                            Vec3.ZERO)))
                            .isInstanceOf(RefusedException.class)
                            .hasMessageStartingWith("feedback for 0.2 s is too late");
                });
        step.advanceTimestep();
        step.advanceTimestep();
        assertThat(step.applied).isEmpty();
    }
}
