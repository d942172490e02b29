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

    private void comesBackWith(WorldObjectDefinition... objects) {
        scene.clear();
        desk.refresh();
        long id = 9;
        for (WorldObjectDefinition object : objects) {
            scene.add(SeenObject.of(id++, object));
        }
        scene.enterWorld();
        desk.refresh();
    }

    @Test
    void anotherWorldIsFittedAndItsOnlyObjectFollowed() {
        comesBackWith(ball("Whale", -50));
        assertThat(camera.target().x()).isEqualTo(-50);
        assertThat(options.followed()).hasValue(9);
    }

    @Test
    void ofTheSameWorldTheCameraIsKept() {
        comesBackWith(Scenes.buoy());
        assertThat(camera.target().x()).isEqualTo(1);
        assertThat(options.followed()).isEmpty();
    }

    @Test
    void anotherWorldThatBeginsLikeTheOneBeforeIsFitted() {
        comesBackWith(Scenes.buoy(), ball("A", 100), ball("B", 200));
        assertThat(camera.target().x()).isGreaterThan(50);
    }

    @Test
    void anotherObjectOfTheSameNameIsAnotherWorld() {
        comesBackWith(ball(Scenes.buoy().name(), -50));
        assertThat(camera.target().x()).isEqualTo(-50);
    }

    private static WorldObjectDefinition ball(String name, double x) {
        return WorldObjectDefinition.named(name)
                .mass(1)
                .volume(new Sphere(3))
                .position(x, 0, 0)
                .build();
    }
}
