package org.auvsim.examples.mine;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;

import java.io.InputStream;
import java.util.Optional;

/** The mine in a scenario file: its records are elements, found by the provider files. */
class MinefieldScenarioTest {
    @Test
    void aScenarioNamesTheMineAndTheHull() throws Exception {
        World world = load("minefield.xml");

        while (world.time() < 0.3) {
            world.advanceTimestep();
        }

        assertThat(world.objects())
                .extracting(o -> o.name())
                .containsExactly("Vehicle", "Bystander");
        // 90 points at 1 m, 5 m off: 3.6 points.
        assertThat(world.object("Bystander").component(Hull.class).orElseThrow().strength())
                .isBetween(56.39, 56.41);
        assertThat(world.object("Bystander").velocity().y()).isPositive();
    }

    private static World load(String name) throws Exception {
        try (InputStream in = MinefieldScenarioTest.class.getResourceAsStream(name)) {
            byte[] text = Optional.ofNullable(in).orElseThrow().readAllBytes();
            return ScenarioLoader.load(MinefieldScenarioTest.class.getClassLoader())
                    .parse(text)
                    .world();
        }
    }
}
