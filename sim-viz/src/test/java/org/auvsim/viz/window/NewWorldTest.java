package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.volume.Sphere;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.drawing.ViewOptions;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;
import org.junit.jupiter.api.Test;

/** A simulator comes back after its connection broke, with this world or with another one. */
class NewWorldTest {
    private final Scene scene = Scenes.withBuoy();
    private final OrbitCamera camera = new OrbitCamera();
    private final ViewOptions options = new ViewOptions();
    private final Desk desk = new Desk(new FakeSimulator(scene), camera, new FakeScreen(), options);

    NewWorldTest() {
        camera.aim(1, 2, 3, 4);
        desk.refresh();
    }

    private void comesBackWith(WorldObjectDefinition object) {
        scene.clear();
        desk.refresh();
        scene.add(SeenObject.of(9, object));
        scene.enterWorld();
        desk.refresh();
    }

    @Test
    void anotherWorldIsFittedAndItsOnlyObjectFollowed() {
        comesBackWith(
                WorldObjectDefinition.named("Whale")
                        .mass(1)
                        .volume(new Sphere(3))
                        .position(-50, 0, 0)
                        .build());
        assertThat(camera.target().x()).isEqualTo(-50);
        assertThat(options.followed()).hasValue(9);
    }

    @Test
    void ofTheSameWorldTheCameraIsKept() {
        comesBackWith(Scenes.buoy());
        assertThat(camera.target().x()).isEqualTo(1);
        assertThat(options.followed()).isEmpty();
    }
}
