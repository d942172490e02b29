package org.auvsim.server.feedback;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.message.feedback.DifferentPositionFeedbackMessage;
import org.auvsim.auvsml.message.feedback.DifferentStateFeedbackMessage;
import org.auvsim.auvsml.message.feedback.FeedbackMessage;
import org.auvsim.core.entity.MovementState;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;

import java.time.Duration;
import java.util.Optional;

/**
 * What every feedback processor must do, a user's own too: subclass this in its test, name the
 * processor, and how near it gets.
 */
public abstract class FeedbackProcessorContract {
    /** The processor under test. */
    protected abstract FeedbackProcessor processor();

    /** How near (m) the object must come to where it was measured, in one step. */
    protected abstract double accuracy();

    private static final double ROUNDING = 1e-12;

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
        return corrected(
                world,
                new DifferentPositionFeedbackMessage(
                        1, 0.05, processor().name(), Vec3.ZERO, measured, Vec3.ZERO));
    }

    private StepRecord corrected(World world, FeedbackMessage message) {
        StepRecord step =
                new StepRecord(
                        world,
                        SimpleFixedTimeFeedbackTimestepper.waiting(Duration.ofMillis(1)),
                        processor());
        step.robot(
                p -> {
                    if (p.time() < 0.06) {
                        step.send(message);
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
    void bringsTheObjectToHowAllOfItsMotionWasMeasured() {
        World world = world();
        Vec3 velocity = new Vec3(1.1, 0.1, 0);
        Vec3 spin = new Vec3(0.1, 0, 0.4);
        Quat orientation = Quat.ofAxisAngle(new Vec3(1, 2, 3), 0.1);
        StepRecord step =
                corrected(
                        world,
                        new DifferentStateFeedbackMessage(
                                1,
                                0.05,
                                processor().name(),
                                Optional.empty(),
                                Optional.of(measured),
                                Optional.of(orientation),
                                Optional.of(velocity),
                                Optional.of(spin),
                                Optional.empty()));
        step.advanceTimestep();
        double near = Math.max(accuracy(), ROUNDING);
        RigidMotion motion = RigidMotion.of(world.object(1));
        assertThat(motion.position().distance(measured)).isLessThanOrEqualTo(near);
        assertThat(motion.velocity().distance(velocity)).isLessThanOrEqualTo(near / 0.025);
        assertThat(motion.angularVelocity().distance(spin)).isLessThanOrEqualTo(near / 0.025);
        Vec3 nose = new Vec3(1, 1, 1);
        assertThat(motion.orientation().rotate(nose).distance(orientation.rotate(nose)))
                .isLessThanOrEqualTo(2 * near);
        MeasurementErrors errors = step.applied.getFirst().after();
        assertThat(errors.angle().orElseThrow()).isLessThanOrEqualTo(near);
        assertThat(step.applied.getFirst().converged()).isTrue();
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
