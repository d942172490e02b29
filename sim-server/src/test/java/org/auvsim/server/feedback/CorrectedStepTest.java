package org.auvsim.server.feedback;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.document.MomentumRule;
import org.auvsim.auvsml.message.command.RefusedException;
import org.auvsim.core.entity.Behavior;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObject;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.step.SnapshotStepper;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;

import java.time.Duration;
import java.util.concurrent.atomic.AtomicInteger;

/** One step with feedback, as section 7.2 of the thesis has it. */
class CorrectedStepTest {
    private static final String DIRECT = "DirectPositionChangeFeedbackHandler";
    private static final String VECTOR = "VectorAdjustmentFeedbackHandler";

    private final World world = world();

    private static World world() {
        return World.builder().timeStep(0.05).add(ball(1, "ship", 0, 0)).build();
    }

    private static WorldObjectDefinition ball(long id, String name, double x, double vx) {
        return WorldObjectDefinition.named(name)
                .id(id)
                .mass(2)
                .volume(new Sphere(1))
                .position(x, 0, 0)
                .velocity(vx, 0, 0)
                .force(NamedForce.direct("engine", Frame.WORLD, new Vec3(4, 0, 0)))
                .build();
    }

    private static FeedbackTimestepper waiting() {
        return SimpleFixedTimeFeedbackTimestepper.waiting(Duration.ofMillis(10));
    }

    @Test
    void directAlterationComesAfterTheActualStepAndIsToldOnceMore() {
        StepRecord step = new StepRecord(world, waiting());
        step.robot(p -> step.send(1, p.time(), DIRECT, new Vec3(0, 3, 0)));
        step.advanceTimestep();
        assertThat(step.told)
                .containsExactly(
                        "projected 0.05",
                        "advanced 0.05",
                        "moved 1",
                        "applied " + DIRECT,
                        "finished 0.05");
        assertThat(world.object(1).position()).isEqualTo(new Vec3(0, 3, 0));
        assertThat(world.object(1).linearMomentum().x()).isCloseTo(0.2, within(1e-12));
        assertThat(step.errorBefore(0)).isCloseTo(3, within(1e-4));
        assertThat(step.errorAfter(0)).isZero();
    }

    @Test
    void vectorAdjustmentComesBeforeTheActualStepAndIsGoneAfterIt() {
        StepRecord step = new StepRecord(world, waiting());
        step.robot(p -> step.send(1, p.time(), VECTOR, new Vec3(0.01, 0.02, 0)));
        step.advanceTimestep();
        assertThat(step.told)
                .containsExactly(
                        "projected 0.05", "advanced 0.05", "applied " + VECTOR, "finished 0.05");
        assertThat(world.object(1).position().distance(new Vec3(0.01, 0.02, 0))).isLessThan(1e-8);
        assertThat(world.object(1).forces()).extracting(NamedForce::name).containsExactly("engine");
    }

    @Test
    void withoutFeedbackTheWorldIsTheSameBitForBit() {
        World alone = world.copy();
        StepRecord step = new StepRecord(world, waiting());
        for (int i = 0; i < 20; i++) {
            step.advanceTimestep();
            alone.advanceTimestep();
        }
        assertThat(world.stateHash()).isEqualTo(alone.stateHash());
    }

    @Test
    void feedbackForOneObjectIsUsedInOrderOfTimestampThenOfArrival() {
        StepRecord step = new StepRecord(world, waiting());
        step.robot(
                p -> {
                    step.send(1, p.time(), DIRECT, new Vec3(0, 3, 0));
                    step.send(1, p.time(), DIRECT, new Vec3(0, 4, 0));
                    step.send(1, p.time() - 1e-7, DIRECT, new Vec3(0, 9, 0));
                });
        step.advanceTimestep();
        assertThat(step.applied).hasSize(3);
        assertThat(step.errorBefore(0)).isCloseTo(9, within(1e-3));
        assertThat(step.errorBefore(1)).isEqualTo(6);
        assertThat(step.errorBefore(2)).isEqualTo(1);
        assertThat(world.object(1).position()).isEqualTo(new Vec3(0, 4, 0));
    }

    @Test
    void anotherTimestampThanThatOfTheStepsEndIsRefused() {
        StepRecord step = new StepRecord(world, waiting());
        step.robot(
                _ -> {
                    assertThatThrownBy(() -> step.send(1, 0, DIRECT, Vec3.ZERO))
                            .isInstanceOf(RefusedException.class)
                            .hasMessageStartingWith("feedback for 0.0 s is too late");
                    assertThatThrownBy(() -> step.send(1, 0.1, DIRECT, Vec3.ZERO))
                            .isInstanceOf(RefusedException.class)
                            .hasMessageStartingWith("feedback for 0.1 s is too early");
                });
        step.advanceTimestep();
        assertThatThrownBy(() -> step.send(1, 0.05, DIRECT, Vec3.ZERO))
                .isInstanceOf(RefusedException.class)
                .hasMessageContaining("too late");
        assertThat(step.applied).isEmpty();
    }

    @Test
    void anUnknownHandlerIsRefusedAndTheKnownOnesAreNamed() {
        StepRecord step = new StepRecord(world, waiting());
        assertThatThrownBy(() -> step.send(1, 0, "Magic", Vec3.ZERO))
                .isInstanceOf(RefusedException.class)
                .hasMessage(
                        "no feedback processor has the name 'Magic'; there are "
                                + DIRECT
                                + ", IgnoreFeedbackHandler, KalmanFilterFeedbackHandler, "
                                + VECTOR);
    }

    @Test
    void aSimulatorWithoutFeedbackSaysSo() {
        StepRecord step = new StepRecord(world, new NoFeedbackTimestepper());
        assertThatThrownBy(() -> step.send(1, 0, DIRECT, Vec3.ZERO))
                .isInstanceOf(RefusedException.class)
                .hasMessageContaining("uses no feedback");
    }

    @Test
    void asynchronousFeedbackIsUsedBetweenTwoSteps() {
        StepRecord step = new StepRecord(world, new AsynchronousFeedbackTimestepper());
        step.advanceTimestep();
        step.send(1, 0, DIRECT, new Vec3(0, 3, 0));
        assertThatThrownBy(() -> step.send(1, 0.1, DIRECT, Vec3.ZERO))
                .isInstanceOf(RefusedException.class)
                .hasMessageContaining("too early");
        step.advanceTimestep();
        assertThat(step.told)
                .containsExactly(
                        "advanced 0.05",
                        "finished 0.05",
                        "applied " + DIRECT,
                        "advanced 0.1",
                        "finished 0.1");
        // From (0, 3, 0) with 0.1 m/s at 0.05 s, pushed by 4 N / 2 kg for another 0.05 s.
        assertThat(world.object(1).position().distance(new Vec3(0.0075, 3, 0))).isLessThan(1e-12);
    }

    /** Counts how often it acts, in the world and in its copies. */
    private record Counting(String name, AtomicInteger acts) implements Behavior {
        @Override
        public void act(double time, WorldObject self) {
            acts.incrementAndGet();
        }
    }

    @Test
    void asynchronousDirectAlterationProjectsNothing() {
        AtomicInteger acts = new AtomicInteger();
        world.object(1).add(new Counting("counting", acts));
        StepRecord step = new StepRecord(world, new AsynchronousFeedbackTimestepper());
        step.advanceTimestep();
        int once = acts.get();
        assertThat(once).isPositive();
        step.send(1, world.time(), DIRECT, new Vec3(0, 3, 0));
        step.advanceTimestep();
        assertThat(step.applied).hasSize(1);
        assertThat(acts).hasValue(2 * once);
    }

    /** Looks where the step would end, and then moves the object. */
    private record LooksFirst(String name) implements FeedbackProcessor {
        @Override
        public Phase phase() {
            return Phase.AFTER_STEP;
        }

        @Override
        public void process(Correction correction) {
            assertThat(correction.duration()).isLessThan(0.05);
            correction.object().setPosition(correction.target().position().orElseThrow());
        }
    }

    /** The torpedo would hit the rock in this step, but the rock turns out to be elsewhere. */
    @Test
    void aCorrectionOfTheWorldIsSeenByTheNextProjection() {
        World world =
                World.builder()
                        .stepper(SnapshotStepper.standard())
                        .add(ball(1, "ship", 0, 0))
                        .build();
        world.add(ball(2, "rock", 50, 0));
        world.add(ball(3, "torpedo", 47.9, 4));
        StepRecord step =
                new StepRecord(
                        world, new AsynchronousFeedbackTimestepper(), new LooksFirst("looks"));
        step.send(2, 0, "looks", new Vec3(50, 90, 0));
        step.send(3, 0, VECTOR, new Vec3(47.9, 0.01, 0));
        step.advanceTimestep();
        assertThat(step.refused).isEmpty();
        assertThat(world.time()).isEqualTo(0.05);
        Vec3 free = new Vec3(47.9 + 4 * 0.05 + 0.05 * 0.05, 0.01, 0);
        assertThat(world.object(3).position().distance(free)).isLessThan(1e-8);
    }

    @Test
    void asynchronousVectorAdjustmentAddsTheModelsOwnMotion() {
        StepRecord step = new StepRecord(world, new AsynchronousFeedbackTimestepper());
        World alone = world.copy();
        alone.advanceTimestep();
        step.send(1, 0, VECTOR, new Vec3(0, 0.02, 0));
        step.advanceTimestep();
        Vec3 wanted = alone.object(1).position().plus(new Vec3(0, 0.02, 0));
        assertThat(world.object(1).position().distance(wanted)).isLessThan(1e-8);
    }

    @Test
    void anOverlapThatDirectAlterationMakesIsNamed() {
        world.add(ball(7, "rock", 10, 0));
        StepRecord step = new StepRecord(world, waiting());
        step.robot(p -> step.send(1, p.time(), DIRECT, new Vec3(9, 0, 0)));
        step.advanceTimestep();
        assertThat(step.applied.getFirst().overlaps()).containsExactly(7L);
    }

    /**
     * The torpedo would pass the rock, its vector adjustment makes it hit: the world stops before
     * the step's projected end, and the ship's direct alteration, true at that end, waits for it.
     */
    @Test
    void feedbackForAfterTheStepWaitsWhenTheWorldStoppedEarlier() {
        world.add(ball(2, "rock", 50, 0));
        world.add(ball(3, "torpedo", 47.9, 0));
        StepRecord step =
                new StepRecord(
                        world,
                        waiting(),
                        new VectorAdjustmentFeedbackHandler(MomentumRule.AS_THESIS));
        step.robot(
                p -> {
                    if (p.time() == 0.05 && world.time() == 0) {
                        step.send(3, p.time(), VECTOR, new Vec3(48.5, 0, 0));
                        step.send(1, p.time(), DIRECT, new Vec3(0, 3, 0));
                    }
                });
        step.advanceTimestep();
        double collision = world.time();
        assertThat(collision).isGreaterThan(0).isLessThan(0.05);
        assertThat(step.applied).extracting(AppliedFeedback::processor).containsExactly(VECTOR);
        step.advanceTimestep();
        assertThat(world.time()).isCloseTo(0.05, within(1e-12));
        assertThat(step.applied)
                .extracting(AppliedFeedback::processor)
                .containsExactly(VECTOR, DIRECT);
        assertThat(world.object(1).position()).isEqualTo(new Vec3(0, 3, 0));
    }

    @Test
    void directAlterationLeavesAFixedObjectWhereItIs() {
        world.add(
                WorldObjectDefinition.named("pier")
                        .id(9)
                        .fixed()
                        .volume(new Sphere(1))
                        .position(30, 0, 0)
                        .build());
        StepRecord step = new StepRecord(world, waiting());
        step.robot(p -> step.send(9, p.time(), DIRECT, Vec3.ZERO));
        step.advanceTimestep();
        assertThat(world.object(9).position()).isEqualTo(new Vec3(30, 0, 0));
        assertThat(step.applied).isEmpty();
        assertThat(step.refused)
                .extracting(Throwable::getMessage)
                .containsExactly("'pier' is fixed, and stays where it is whatever is measured");
    }

    @Test
    void feedbackForAnObjectThatHasLeftIsRefused() {
        StepRecord step = new StepRecord(world, waiting());
        step.robot(
                p -> {
                    step.send(1, p.time(), DIRECT, Vec3.ZERO);
                    world.remove(1);
                });
        step.advanceTimestep();
        assertThat(step.refused)
                .extracting(Throwable::getMessage)
                .containsExactly("no world object has the id 1 at 0.05 s");
    }
}
