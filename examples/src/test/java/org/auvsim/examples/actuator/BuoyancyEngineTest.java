package org.auvsim.examples.actuator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;

import java.util.Optional;

class BuoyancyEngineTest {
    /** While the pump runs, the lift grows evenly: v = 10,000 rate t^2 / (2 m). */
    @Test
    void theGliderRisesFasterAndFasterWhileThePumpRuns() {
        World world =
                World.builder()
                        .add(
                                WorldObjectDefinition.named("Glider")
                                        .volume(new Sphere(0.5))
                                        .mass(50)
                                        .component(
                                                new BuoyancyEngine(
                                                        "Pump",
                                                        0,
                                                        1e-5,
                                                        Vec3.ZERO,
                                                        Optional.empty()))
                                        .build())
                        .build();
        world.object("Glider").command(BuoyancyEngine.class, "Pump", 2e-4);

        while (world.time() < 10 - 1e-9) {
            world.advanceTimestep();
        }

        assertThat(world.object("Glider").velocity().z())
                .isEqualTo(0.1 * world.time() * world.time() / (2 * 50), within(1e-9));
    }
}
