package org.auvsim.server.feedback;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.entity.MovementState;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;

import java.time.Duration;

/**
 * What every feedback processor must do, a user's own too: subclass this in its test, name the
 * processor, and how near it gets.
 */
public abstract class FeedbackProcessorContract {
    /** The processor under test. */
    protected abstract FeedbackProcessor processor();

    /** How near (m) the object must come to where it was measured, in one step. */
    protected abstract double accuracy();

    private final Vec3 measured = new Vec3(0.06, -0.01, 0.02);

    private static World world() {
        return World.builder()
                .timeStep(0.05)
                .add(ball(1, "ship", 0))
                .add(ball(2, "buoy", 9))
                .build();
    }

    private static WorldObjectDefinition ball(long id, String name, double y) {
        return WorldObjectDefinition.named(name)
                .id(id)
                .mass(2)
                .volume(new Sphere(1))
                .position(0, y, 0)
                .velocity(1, 0, 0)
                .angularVelocity(0, 0, 0.5)
                .build();
    }

    private StepRecord corrected(World world) {
        StepRecord step =
                new StepRecord(
                        world,
                        SimpleFixedTimeFeedbackTimestepper.waiting(Duration.ofMillis(1)),
                        processor());
        step.robot(
                p -> {
                    if (p.time() < 0.06) {
                        step.send(1, p.time(), processor().name(), measured);
                    }
                });
        return step;
    }

    @Test
    void bringsTheObjectToWhereItWasMeasured() {
        World world = world();
        StepRecord step = corrected(world);
        step.advanceTimestep();
        assertThat(world.object(1).position().distance(measured)).isLessThanOrEqualTo(accuracy());
        assertThat(step.applied).hasSize(1);
        assertThat(step.applied.getFirst().processor()).isEqualTo(processor().name());
        assertThat(step.errorAfter(0)).isLessThanOrEqualTo(accuracy());
    }

    @Test
    void leavesOtherObjectsAlone() {
        World world = world();
        World uncorrected = world();
        corrected(world).advanceTimestep();
        uncorrected.advanceTimestep();
        MovementState is = world.object(2).movementState();
        MovementState ought = uncorrected.object(2).movementState();
        assertThat(is.position().distance(ought.position())).isLessThan(1e-12);
        assertThat(is.linearMomentum()).isEqualTo(ought.linearMomentum());
    }

    @Test
    void leavesNoForceBehind() {
        World world = world();
        StepRecord step = corrected(world);
        step.advanceTimestep();
        assertThat(world.object(1).forces()).extracting(NamedForce::name).isEmpty();
        MovementState before = world.object(1).movementState();
        step.advanceTimestep();
        assertThat(world.object(1).linearMomentum().distance(before.linearMomentum()))
                .isLessThan(1e-12);
    }

    @Test
    void givesTheSameBitsForTheSameFeedback() {
        World one = world();
        World other = world();
        corrected(one).advanceTimestep();
        corrected(other).advanceTimestep();
        assertThat(one.stateHash()).isEqualTo(other.stateHash());
    }
}
