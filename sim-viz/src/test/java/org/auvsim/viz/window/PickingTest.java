package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;
import org.junit.jupiter.api.Test;

import java.util.OptionalLong;

class PickingTest {
    private static final int WIDTH = 800;
    private static final int HEIGHT = 600;

    private final Scene scene = Scenes.withBuoy();
    private final OrbitCamera camera = new OrbitCamera();

    @Test
    void aClickOnTheRoundOfAnObjectMeansIt() {
        camera.aim(5, 0, 0, 20);
        double radius = camera.pixelsPerMetre(20, HEIGHT);
        assertThat(pick(WIDTH / 2 + (int) radius - 1)).isEqualTo(OptionalLong.of(9));
        assertThat(pick(WIDTH / 2 + (int) radius + 2)).isEmpty();
    }

    @Test
    void aFarObjectIsHitByAClickNearIt() {
        camera.aim(5, 0, 0, 5000);
        assertThat(pick(WIDTH / 2 + 10)).isEqualTo(OptionalLong.of(9));
        assertThat(pick(WIDTH / 2 + 15)).isEmpty();
    }

    @Test
    void whatIsBehindTheCameraIsNotMeant() {
        camera.look(0, 0);
        camera.aim(-25, 0, 0, 20);
        assertThat(pick(WIDTH / 2)).isEmpty();
    }

    @Test
    void ofTwoTheOneInTheMiddleOfTheClickIsMeant() {
        scene.add(SeenObject.of(10, Scenes.buoy().toBuilder().id(10).position(5, 1.5, 0).build()));
        scene.look(0, look -> {});
        camera.look(0, 0);
        camera.aim(5, 0, 0, 20);
        double pixels = camera.pixelsPerMetre(20, HEIGHT);
        assertThat(pick(WIDTH / 2 + (int) (0.6 * pixels))).isEqualTo(OptionalLong.of(9));
        assertThat(pick(WIDTH / 2 + (int) (0.9 * pixels))).isEqualTo(OptionalLong.of(10));
    }

    private OptionalLong pick(int x) {
        return Picking.at(scene, camera, x, HEIGHT / 2, WIDTH, HEIGHT);
    }
}
