package org.auvsim.server.feedback;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Vec3;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;

import java.time.Duration;

class IgnoreFeedbackHandlerTest {
    @Test
    void itChangesNothingAndSaysHowFarTheObjectIs() {
        World world = World.builder().add(FilteredRobot.ball(new Vec3(1, 0, 0), Vec3.ZERO)).build();
        World alone = world.copy();
        StepRecord step =
                new StepRecord(
                        world, SimpleFixedTimeFeedbackTimestepper.waiting(Duration.ofMillis(1)));
        step.robot(p -> step.send(1, p.time(), "IgnoreFeedbackHandler", new Vec3(p.time(), 0, 2)));
        step.advanceTimestep();
        alone.advanceTimestep();
        assertThat(world.stateHash()).isEqualTo(alone.stateHash());
        assertThat(step.told).noneMatch(told -> told.startsWith("moved"));
        assertThat(step.errorBefore(0)).isCloseTo(2, within(1e-12));
        assertThat(step.errorAfter(0)).isEqualTo(step.errorBefore(0));
    }
}
