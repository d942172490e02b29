package org.auvsim.examples.behavior;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;

class KeepDepthTest {
    @Test
    void theVehicleGoesToItsDepthAndStays() {
        World world =
                World.builder()
                        .add(
                                WorldObjectDefinition.named("Diver")
                                        .volume(new Sphere(0.5))
                                        .mass(10)
                                        .component(new KeepDepth("depth", 5, 10, 20))
                                        .build())
                        .build();

        while (world.time() < 30) {
            world.advanceTimestep();
        }

        assertThat(world.object("Diver").position().z()).isEqualTo(-5, within(1e-6));
        assertThat(world.object("Diver").velocity().norm()).isLessThan(1e-6);
    }
}
