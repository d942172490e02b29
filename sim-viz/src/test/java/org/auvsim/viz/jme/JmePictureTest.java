package org.auvsim.viz.jme;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.Message;
import org.auvsim.auvsml.message.control.GetSimulatorStateRequest;
import org.auvsim.auvsml.message.control.SimulatorStateResponse;
import org.auvsim.auvsml.message.control.StepCommand;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.auvsim.server.net.TcpTransport;
import org.auvsim.server.simulator.Simulator;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.camera.StandardView;
import org.auvsim.viz.drawing.Layer;
import org.auvsim.viz.drawing.SceneDrawing;
import org.auvsim.viz.drawing.ViewOptions;
import org.auvsim.viz.scene.Movement;
import org.auvsim.viz.source.LiveSource;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.awt.image.BufferedImage;
import java.util.OptionalLong;

/**
 * Pictures of a known scene: a red ball runs into a blue one of its mass, which rolls on in its
 * stead, as elastic collisions of equal masses end; a yellow box stands above.
 */
@Tag("display")
@Timeout(120)
class JmePictureTest {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 480;
    private static final int RED = 0xe0504a;
    private static final int BLUE = 0x4b83e8;
    private static final int YELLOW = 0xe6c84f;
    private static final int PINK = 0xff4fa3;

    private final TcpTransport tcp = TcpTransport.onLoopback(0);
    private final Simulator simulator =
            Simulator.of(
                            World.builder()
                                    .timeStep(0.1)
                                    .add(ball("Red", 1, -3, 2))
                                    .add(ball("Blue", 2, 0, 0))
                                    .add(
                                            WorldObjectDefinition.named("Yellow")
                                                    .id(3)
                                                    .mass(1)
                                                    .volume(new Box(new Vec3(1, 1, 1)))
                                                    .position(0, 3, 0)
                                                    .build())
                                    .build())
                    .paused()
                    .transport(tcp)
                    .start();

    private final OrbitCamera camera = new OrbitCamera();
    private final ViewOptions options = new ViewOptions();
    private LiveSource source;

    private static WorldObjectDefinition ball(String name, long id, double x, double vx) {
        return WorldObjectDefinition.named(name)
                .id(id)
                .mass(2)
                .volume(new Sphere(0.5))
                .position(x, 0, 0)
                .velocity(vx, 0, 0)
                .build();
    }

    @BeforeEach
    void connect() throws Exception {
        source =
                LiveSource.connect(
                        "127.0.0.1",
                        tcp.port(),
                        MessageCatalogue.load(JmePictureTest.class.getClassLoader()));
        source.ready().get();
        for (Layer layer : Layer.values()) {
            options.show(layer, false);
        }
        camera.aim(0, 0, 0, 12);
        StandardView.TOP.apply(camera);
    }

    @AfterEach
    void disconnect() {
        source.close();
        simulator.close();
    }

    private BufferedImage picture() throws Exception {
        return new JmeRenderer().picture(new SceneDrawing(source, options, camera), WIDTH, HEIGHT);
    }

    private double[] pixel(double x, double y, double z) {
        double[] at = new double[3];
        camera.project(x, y, z, WIDTH, HEIGHT, at);
        return at;
    }

    private void makeSteps(int count) throws Exception {
        source.ask(new StepCommand(count)).get();
        Message state = source.ask(new GetSimulatorStateRequest()).get();
        while (((SimulatorStateResponse) state).step() < count) {
            state = source.ask(new GetSimulatorStateRequest()).get();
        }
        source.ask(new GetSimulatorStateRequest()).get();
    }

    @Test
    void ballsAreWhereTheyAreBeforeAndAfterTheyMeet() throws Exception {
        BufferedImage before = picture();
        assertThat(Colours.hasHue(before, pixel(-3, 0, 0), RED)).isTrue();
        assertThat(Colours.hasHue(before, pixel(0, 0, 0), BLUE)).isTrue();
        int empty = Colours.rgb(before, pixel(-1.5, 0, 0));
        assertThat(empty).isEqualTo(0x10202c);

        makeSteps(20); // they meet after 1 s, and blue goes on for 2 m
        BufferedImage after = picture();
        assertThat(Colours.rgb(after, pixel(-3, 0, 0))).isEqualTo(empty);
        assertThat(Colours.hasHue(after, pixel(-1, 0, 0), RED)).isTrue();
        assertThat(Colours.hasHue(after, pixel(2, 0, 0), BLUE)).isTrue();
        assertThat(Colours.rgb(after, pixel(0.5, 0, 0))).isEqualTo(empty);
        assertThat(after.getWidth()).isEqualTo(WIDTH);
        assertThat(after.getHeight()).isEqualTo(HEIGHT);
    }

    @Test
    void shapesEndWhereTheyEnd() throws Exception {
        camera.perspective(false);
        BufferedImage picture = picture();
        assertThat(Colours.hasHue(picture, pixel(0.45, 3.45, 0.5), YELLOW)).isTrue();
        assertThat(Colours.rgb(picture, pixel(0.56, 3.45, 0.5))).isEqualTo(0x10202c);
        assertThat(Colours.hasHue(picture, pixel(-3, 0.46, 0), RED)).isTrue();
        assertThat(Colours.rgb(picture, pixel(-3, 0.55, 0))).isEqualTo(0x10202c);
    }

    @Test
    void aProjectedStateIsAGhost() throws Exception {
        options.show(Layer.GHOSTS, true);
        source.scene()
                .project(
                        1,
                        new Movement(9, new Vec3(-2, -2, 0), Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO));
        BufferedImage picture = picture();
        int solid = Colours.rgb(picture, pixel(-3, 0, 0));
        int ghost = Colours.rgb(picture, pixel(-2, -2, 0));
        assertThat(ghost >> 16).isBetween(0x10 + 10, (solid >> 16) - 10);
    }

    @Test
    void aMeasuredPlaceIsSeenWithinItsObject() throws Exception {
        options.show(Layer.MEASUREMENTS, true);
        source.scene().measure(1, 0, new Vec3(-3, 0, 0));
        BufferedImage picture = picture();
        double arm = 0.01 * camera.height();
        assertThat(Colours.hasHue(picture, pixel(-3 + arm, 0, 0), PINK)).isTrue();
        assertThat(Colours.hasHue(picture, pixel(-3 + arm, 2 * arm, 0), RED)).isTrue();
    }

    /** Its middle is at the picture's left edge, and as much of it is seen as in the middle. */
    @Test
    void aNameAtThePicturesEdgeIsWhole() throws Exception {
        options.show(Layer.LABELS, true);
        source.scene().remove(2);
        source.scene().remove(3);
        double half = camera.height() * WIDTH / HEIGHT / 2;
        camera.aim(-3, 0, 0, 12);
        int whole = light(picture());
        camera.aim(-3 + half - 0.01, 0, 0, 12);
        assertThat(light(picture())).isEqualTo(whole);
    }

    /** How many pixels are as light as the words of a dark picture. */
    private static int light(BufferedImage picture) {
        int count = 0;
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                count += (picture.getRGB(x, y) & 0xff) > 0xc0 ? 1 : 0;
            }
        }
        return count;
    }

    @Test
    void lightAndLayersAreAsChosen() throws Exception {
        options.dark(false);
        options.show(Layer.AXES, true);
        BufferedImage picture = picture();
        assertThat(Colours.rgb(picture, pixel(4, -3, 0))).isEqualTo(0xe9f1f6);
        assertThat(Colours.hasHue(picture, pixel(0.7, 0, 0), RED)).isTrue();
    }

    /** The camera goes to it while the frame is painted. */
    @Test
    void whatIsFollowedIsInTheMiddleOfEachFrame() throws Exception {
        options.follow(OptionalLong.of(1));
        BufferedImage picture = picture();
        assertThat(Colours.hasHue(picture, new double[] {WIDTH / 2.0, HEIGHT / 2.0}, RED)).isTrue();
        assertThat(Colours.hasHue(picture, pixel(0, 0, 0), BLUE)).isTrue();
    }

    @Test
    void farFromTheOriginItLooksTheSame() throws Exception {
        Vec3 far = new Vec3(4e6, -7e6, -40);
        source.scene().jump(1, new Movement(0, far, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO));
        camera.aim(far.x(), far.y(), far.z(), 12);
        BufferedImage picture = picture();
        assertThat(Colours.hasHue(picture, pixel(far.x() + 0.4, far.y(), far.z()), RED)).isTrue();
        assertThat(Colours.rgb(picture, pixel(far.x() + 0.6, far.y(), far.z())))
                .isEqualTo(0x10202c);
    }
}
