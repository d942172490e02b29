package org.auvsim.examples.effect;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;

class SpringTest {
    @Test
    void aBodyOnASpringSwingsAsACosine() {
        World world =
                World.builder()
                        .timeStep(0.01)
                        .add(
                                WorldObjectDefinition.named("Bob")
                                        .volume(new Sphere(0.5))
                                        .mass(2)
                                        .position(4, 0, 0)
                                        .effect(new Spring(new Vec3(3, 0, 0), 8))
                                        .build())
                        .build();

        for (int step = 0; step < 500; step++) {
            world.advanceTimestep();
            // The angular frequency is sqrt(k / m) = 2 rad/s.
            assertThat(world.object("Bob").position().x())
                    .isEqualTo(3 + StrictMath.cos(2 * world.time()), within(1e-7));
        }
    }
}
