package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.recording.RecordingWriter;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.recording.Recording;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.replay.Recorder;
import org.auvsim.server.simulator.Simulator;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.camera.StandardView;
import org.auvsim.viz.drawing.SceneDrawing;
import org.auvsim.viz.drawing.Screen;
import org.auvsim.viz.drawing.ViewOptions;
import org.auvsim.viz.jme.Colours;
import org.auvsim.viz.jme.JmeRenderer;
import org.auvsim.viz.source.LiveSource;
import org.auvsim.viz.source.RecordedSource;
import org.auvsim.viz.source.Source;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

import java.awt.Component;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;

import javax.swing.AbstractButton;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.JTabbedPane;

/** A real window, painted by OpenGL, of a simulator over a real socket and of its recording. */
@Tag("display")
@Timeout(120)
class SteeringEndToEndTest {
    private static final int RED = 0xe0504a;

    @TempDir private Path folder;
    private final OrbitCamera camera = new OrbitCamera();
    private final ViewOptions options = new ViewOptions();
    private final List<AutoCloseable> opened = new ArrayList<>();

    private static World world() {
        return World.builder().timeStep(0.1).add(ball("Red", 1, 0)).add(ball("Blue", 2, 6)).build();
    }

    private static WorldObjectDefinition ball(String name, long id, double x) {
        return WorldObjectDefinition.named(name)
                .id(id)
                .mass(2)
                .volume(new Sphere(1))
                .position(x, 0, 0)
                .build();
    }

    @AfterEach
    void close() throws Exception {
        for (AutoCloseable each : opened.reversed()) {
            each.close();
        }
    }

    private <T extends AutoCloseable> T closing(T opened) {
        this.opened.add(opened);
        return opened;
    }

    private Simulator serving(TcpTransport tcp) {
        return closing(Simulator.of(world()).transport(tcp).start());
    }

    private LiveSource connected(TcpTransport tcp) throws Exception {
        LiveSource source =
                closing(
                        LiveSource.connect(
                                "127.0.0.1",
                                tcp.port(),
                                MessageCatalogue.load(getClass().getClassLoader())));
        source.ready().get();
        return source;
    }

    /** A window that looks from above, and its screen. */
    private record Shown(ViewerWindow window, Screen screen) {}

    private Shown show(Source source) throws Exception {
        camera.aim(3, 0, 0, 20);
        StandardView.TOP.apply(camera);
        List<Shown> shown = new ArrayList<>();
        List<CompletableFuture<Void>> started = new ArrayList<>();
        Clicks.inSwing(
                () -> {
                    Screen screen =
                            new JmeRenderer().screen(new SceneDrawing(source, options, camera));
                    ViewerWindow window =
                            new ViewerWindow(
                                    source, camera, screen, options, Optional::empty, () -> {});
                    shown.add(new Shown(window, screen));
                    started.add(window.show());
                });
        Shown all = shown.getFirst();
        closing(all.screen());
        closing(() -> Clicks.inSwing(all.window()::close));
        started.getFirst().get();
        return all;
    }

    private double[] pixel(Shown shown, double x) {
        Component on = shown.screen().component();
        double[] at = new double[3];
        camera.project(x, 0, 0, on.getWidth(), on.getHeight(), at);
        return at;
    }

    private static void await(BooleanSupplier event) {
        while (!event.getAsBoolean()) {
            Thread.onSpinWait();
        }
    }

    @Test
    void pausesSelectsPushesAndSeesWhatComesOfIt() throws Exception {
        TcpTransport tcp = TcpTransport.onLoopback(0);
        Simulator simulator = serving(tcp);
        Shown shown = show(connected(tcp));
        await(() -> shown.window().frame().isShowing());

        Clicks.inSwing(
                () -> Clicks.find(shown.window(), "pause-item", AbstractButton.class).doClick(0));
        await(() -> !simulator.state().running());

        double[] red = pixel(shown, 0);
        Clicks.inSwing(() -> Clicks.click(shown.screen().component(), (int) red[0], (int) red[1]));
        assertThat(options.selected()).isEqualTo(OptionalLong.of(1));

        Clicks.inSwing(
                () -> {
                    Clicks.find(shown.window(), "right", JTabbedPane.class).setSelectedIndex(1);
                    Clicks.find(shown.window(), "force-x", JSpinner.class).setValue(4.0);
                    Clicks.find(shown.window(), "apply-force", AbstractButton.class).doClick(0);
                });
        await(() -> !simulator.ask(world -> world.object(1).forces()).isEmpty());
        NamedForce force = simulator.ask(world -> world.object(1).forces()).getFirst();
        assertThat(force.vector()).isEqualTo(new Vec3(4, 0, 0));

        long before = simulator.state().step();
        simulator.advanceTimestep();
        await(() -> simulator.state().step() == before + 1);
        for (int i = 0; i < 14; i++) {
            simulator.advanceTimestep();
        }
        // 2 m/s^2 for 1.5 s.
        double x = simulator.ask(world -> world.object(1).position().x());
        assertThat(x).isCloseTo(2.25, within(1e-9));
        await(() -> redAt(shown, x));
        assertThat(Colours.hasHue(picture(shown), pixel(shown, -0.9), RED)).isFalse();
    }

    private boolean redAt(Shown shown, double x) {
        options.select(OptionalLong.empty());
        return Colours.hasHue(picture(shown), pixel(shown, x + 0.8), RED);
    }

    private static BufferedImage picture(Shown shown) {
        return shown.screen().picture().join();
    }

    @Test
    void scrubsARecording() throws Exception {
        Path file = folder.resolve("run.auvsml.gz");
        AuvsmlMapper mapper = AuvsmlMapper.load(getClass().getClassLoader());
        Scenario scenario = Scenario.of(moving());
        try (Recorder recorder =
                        Recorder.start(
                                new RecordingWriter(Files.newOutputStream(file), mapper),
                                new Recording(Recording.VERSION, "auvsim test", 5),
                                scenario);
                Simulator simulator =
                        Simulator.of(scenario)
                                .rate(OptionalDouble.empty())
                                .paused()
                                .log(recorder)
                                .start()) {
            for (int i = 0; i < 40; i++) {
                simulator.advanceTimestep();
            }
        }
        Shown shown = show(closing(RecordedSource.open(file, mapper, _ -> {})));
        assertThat(Colours.hasHue(picture(shown), pixel(shown, 0), RED)).isTrue();
        Clicks.inSwing(
                () -> {
                    JSlider time = Clicks.find(shown.window(), "time", JSlider.class);
                    time.setValue(time.getMaximum() / 2);
                });
        await(() -> Colours.hasHue(picture(shown), pixel(shown, 2), RED));
        assertThat(Colours.hasHue(picture(shown), pixel(shown, 0), RED)).isFalse();
        Clicks.inSwing(() -> Clicks.find(shown.window(), "time", JSlider.class).setValue(0));
        await(() -> Colours.hasHue(picture(shown), pixel(shown, 0), RED));
    }

    /** The red ball goes 4 m in 4 s. */
    private static World moving() {
        return World.builder()
                .timeStep(0.1)
                .add(
                        WorldObjectDefinition.named("Red")
                                .id(1)
                                .mass(2)
                                .volume(new Sphere(0.5))
                                .velocity(1, 0, 0)
                                .build())
                .build();
    }
}
