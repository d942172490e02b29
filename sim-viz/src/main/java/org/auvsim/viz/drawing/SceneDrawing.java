package org.auvsim.viz.drawing;

import static java.util.Objects.requireNonNull;

import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.scene.SceneLook;
import org.auvsim.viz.source.Source;
import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.function.Consumer;

/** Paints a source's scene, part by part. */
public final class SceneDrawing implements Painter {
    private final Source source;
    private final ViewOptions options;
    private final OrbitCamera camera;
    private final List<Part> parts =
            List.of(
                    new Ground(),
                    new Bodies(),
                    new Trails(),
                    new Velocities(),
                    new Forces(),
                    new SensorBeams(),
                    new Marks(),
                    new Currents(),
                    new WaterSurface(),
                    new Names());

    private final Consumer<SceneLook> viewer = this::paint;
    private @Nullable Picture picture;

    /** What {@code source} shows, as {@code options} say, seen from {@code camera}. */
    public SceneDrawing(Source source, ViewOptions options, OrbitCamera camera) {
        this.source = source;
        this.options = options;
        this.camera = camera;
    }

    @Override
    public void paint(Brush brush, long nanos) {
        source.bring(nanos);
        if (picture == null
                || !picture.brush().equals(brush)
                || !picture.palette().equals(palette())) {
            picture = new Picture(brush, options, palette(), camera);
        }
        source.scene().look(nanos, viewer);
    }

    private void paint(SceneLook look) {
        Picture to = requireNonNull(picture);
        follow(look);
        for (int i = 0; i < parts.size(); i++) {
            parts.get(i).paint(look, to);
        }
    }

    private void follow(SceneLook look) {
        for (int i = 0; i < look.count(); i++) {
            if (options.isFollowed(look.actor(i).object().id())) {
                camera.lookAt(
                        look.actor(i).position(0),
                        look.actor(i).position(1),
                        look.actor(i).position(2));
            }
        }
    }

    private Palette palette() {
        return options.isDark() ? Palette.DARK : Palette.LIGHT;
    }

    @Override
    public OrbitCamera camera() {
        return camera;
    }

    @Override
    public int background() {
        return palette().background();
    }
}
