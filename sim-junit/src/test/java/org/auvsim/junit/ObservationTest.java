package org.auvsim.junit;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;

/** A ball that falls from 1 m and bounces, its steps of 0.1 s; it meets the floor at 0.44 s. */
class ObservationTest {
    private final World world = world();
    private final Observation observation = new Observation(world);

    @Test
    void stepsThatAreMadeAgainShowTheirCollisionsOnce() {
        step(3);
        World before = world.copy();
        step(3);
        assertThat(observation.encounters()).hasSize(1);

        world.restore(before);
        for (int i = 0; i < 3; i++) {
            world.advanceTimestep();
        }
        observation.look();

        assertThat(observation.encounters()).hasSize(1);
        assertThat(ball()).hasSize(7);
    }

    @Test
    void whereTimeGoesBackWhatWasLaterIsForgotten() {
        step(3);
        World before = world.copy();
        step(3);

        world.restore(before);
        step(1);

        assertThat(observation.encounters()).isEmpty();
        assertThat(ball()).hasSize(5);
        step(2);
        assertThat(observation.encounters()).hasSize(1);
        assertThat(ball()).hasSize(7);
    }

    private void step(int count) {
        for (int i = 0; i < count; i++) {
            world.advanceTimestep();
            observation.look();
        }
    }

    private List<Sample> ball() {
        return observation.tracks(_ -> Optional.empty()).getFirst().samples();
    }

    private static World world() {
        String scenario =
                """
                <scenario><time-step delta="0.1"/>
                  <world-object id="1" name="Ball" mass="1" restitution="1"><sphere radius="0.05"/>
                    <position x="0" y="0" z="1"/><gravity acceleration="9.81"/></world-object>
                  <world-object id="2" name="Floor" fixed="1" restitution="1">
                    <box><size x="2" y="2" z="0.1"/></box></world-object>
                </scenario>
                """;
        try {
            return ScenarioLoader.load(ObservationTest.class.getClassLoader())
                    .parse(scenario.getBytes(UTF_8))
                    .world();
        } catch (AuvsmlException e) {
            throw new AssertionError(e);
        }
    }
}
