package org.auvsim.viz;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.volume.Sphere;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.camera.StandardView;
import org.auvsim.viz.drawing.ScreenException;
import org.auvsim.viz.drawing.ViewOptions;
import org.auvsim.viz.scene.LiveClock;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;
import org.junit.jupiter.api.Test;

import java.util.Optional;

class ViewStartTest {
    private final Scene scene = new Scene(new LiveClock());
    private final ViewOptions options = new ViewOptions();

    private void start(Optional<String> follow) throws ScreenException {
        new ViewStart(/* dark= */ true, StandardView.TOP, follow)
                .apply(scene, options, new OrbitCamera());
    }

    private void add(long id, String name, boolean isFixed) {
        var definition = WorldObjectDefinition.named(name).mass(1).volume(new Sphere(1));
        scene.add(SeenObject.of(id, (isFixed ? definition.fixed() : definition).build()));
    }

    @Test
    void whomToFollowInsteadIsSaidInASentence() {
        assertRefused("there are none.");
        add(1, "REMUS 100", false);
        assertRefused("there is REMUS 100.");
        add(2, "Buoy", false);
        assertRefused("there are REMUS 100, Buoy.");
    }

    private void assertRefused(String others) {
        assertThatThrownBy(() -> start(Optional.of("Nemo")))
                .hasMessage("There is no object 'Nemo' to follow; " + others);
    }

    @Test
    void theOnlyObjectThatCanMoveIsFollowed() throws ScreenException {
        add(1, "REMUS 100", false);
        add(2, "Rock", true);
        start(Optional.empty());
        assertThat(options.followed()).hasValue(1);
        assertThat(options.selected()).isEmpty();
    }

    @Test
    void ofTwoThatCanMoveNoneIsFollowed() throws ScreenException {
        add(1, "REMUS 100", false);
        add(2, "Buoy", false);
        start(Optional.empty());
        assertThat(options.followed()).isEmpty();
    }
}
