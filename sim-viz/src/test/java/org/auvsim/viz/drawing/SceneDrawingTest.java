package org.auvsim.viz.drawing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.AiryWave;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.sensor.Dvl;
import org.auvsim.core.sensor.RangeSonar;
import org.auvsim.core.sensor.Sampling;
import org.auvsim.core.sensor.ScalarErrors;
import org.auvsim.core.sensor.Sensor;
import org.auvsim.core.sensor.VectorErrors;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.Capsule;
import org.auvsim.core.volume.Compound;
import org.auvsim.core.volume.Part;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.volume.Volume;
import org.auvsim.viz.camera.OrbitCamera;
import org.auvsim.viz.camera.StandardView;
import org.auvsim.viz.scene.LiveClock;
import org.auvsim.viz.scene.Meeting;
import org.auvsim.viz.scene.Movement;
import org.auvsim.viz.scene.Scene;
import org.auvsim.viz.scene.SeenObject;
import org.auvsim.viz.source.SceneAlone;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.stream.Stream;

class SceneDrawingTest {
    private final Scene scene = new Scene(new LiveClock());
    private final ViewOptions options = new ViewOptions();
    private final OrbitCamera camera = new OrbitCamera();

    SceneDrawingTest() {
        for (Layer layer : Layer.values()) {
            options.show(layer, false);
        }
    }

    private List<String> painted(Layer... layers) {
        for (Layer layer : layers) {
            options.show(layer, true);
        }
        RecordingBrush brush = new RecordingBrush();
        new SceneDrawing(new SceneAlone(scene), options, camera).paint(brush, 0);
        return brush.painted;
    }

    private void add(long id, String name, Volume volume) {
        scene.add(
                SeenObject.of(
                        id,
                        WorldObjectDefinition.named(name)
                                .mass(2)
                                .volume(volume)
                                .position(1, 2, 3)
                                .build()));
    }

    @Test
    void eachVolumeIsPaintedInItsPlace() {
        add(1, "Red Ball", new Sphere(0.5));
        add(2, "Blue Box", new Box(new Vec3(1, 2, 3)));
        add(3, "Green Pill", new Capsule(0.25, 2));
        assertThat(painted())
                .containsExactly(
                        "ball 1.000 2.000 3.000 r 0.500 ffe0504a",
                        "box 1.000 2.000 3.000 s 1.000 2.000 3.000 ff4b83e8",
                        "tube 1.000 2.000 3.000 l 2.000 r 0.250 ff58b865",
                        "ball 0.000 2.000 3.000 r 0.250 ff58b865",
                        "ball 2.000 2.000 3.000 r 0.250 ff58b865");
    }

    @Test
    void partsOfACompoundTurnWithIt() {
        Quat left = Quat.ofAxisAngle(new Vec3(0, 0, 1), Math.PI / 2);
        Compound pair =
                new Compound(
                        List.of(
                                new Part(new Sphere(0.5), new Vec3(2, 0, 0), Quat.IDENTITY),
                                new Part(new Sphere(0.25), new Vec3(0, 1, 0), Quat.IDENTITY)));
        add(1, "Red Pair", pair);
        scene.jump(1, new Movement(0, new Vec3(1, 2, 3), left, Vec3.ZERO, Vec3.ZERO));
        assertThat(painted())
                .containsExactly(
                        "ball 1.000 4.000 3.000 r 0.500 ffe0504a",
                        "ball 0.000 2.000 3.000 r 0.250 ffe0504a");
    }

    @Test
    void whatIsProjectedIsSeenThrough() {
        add(1, "Red Ball", new Sphere(0.5));
        scene.project(1, new Movement(0.1, new Vec3(4, 5, 6), Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO));
        assertThat(painted(Layer.GHOSTS))
                .containsExactly(
                        "ball 1.000 2.000 3.000 r 0.500 ffe0504a",
                        "ball 4.000 5.000 6.000 r 0.500 60e0504a");
    }

    @Test
    void whatIsNotKnownIsABoxInItsPlace() {
        scene.add(new SeenObject(4, "Black Thing", Optional.empty()));
        assertThat(painted()).containsExactly("box 0.000 0.000 0.000 s 0.250 0.250 0.250 ff3a3d40");
    }

    @Test
    void aMeasuredPlaceIsMarkedAndTiedToItsObject() {
        add(1, "Red Ball", new Sphere(0.5));
        scene.measure(1, 0, new Vec3(1, 2, 4));
        assertThat(painted(Layer.MEASUREMENTS))
                .contains("before line 1.000 2.000 3.000 to 1.000 2.000 4.000 ffff4fa3")
                .hasSize(6);
    }

    @Test
    void forcesAndThrustAreArrowsFromWhereTheyAct() {
        scene.add(
                SeenObject.of(
                        1,
                        WorldObjectDefinition.named("Red Robot")
                                .mass(2)
                                .volume(new Sphere(0.5))
                                .orientation(Quat.ofAxisAngle(new Vec3(0, 0, 1), Math.PI / 2))
                                .force(
                                        new NamedForce(
                                                "Push",
                                                Frame.BODY,
                                                new Vec3(2, 0, 0),
                                                new Vec3(0.5, 0, 0)))
                                .component(
                                        new Propulsor(
                                                "Aft",
                                                10,
                                                0.2,
                                                new Vec3(-0.5, 0, 0),
                                                new Vec3(1, 0, 0)))
                                .build()));
        // 2 N on 2 kg: an arrow as long as the ball is wide, along the body's x, the world's y.
        List<String> arrows = painted(Layer.FORCES).subList(1, 5);
        assertThat(arrows).allMatch(line -> line.matches("(tube|cone) -?0.000 .*"));
        assertThat(arrows.get(1)).startsWith("cone 0.000 1.").endsWith("ffff6f4d");
        assertThat(arrows.get(3)).startsWith("cone 0.000 0.").endsWith("ffffa43d");
    }

    /** Along x by a metre a second, for five seconds. */
    private void ran(String name) {
        add(1, name, new Sphere(0.5));
        for (int t = 0; t <= 5; t++) {
            Vec3 place = new Vec3(t, 0, 0);
            scene.move(1, new Movement(t, place, Quat.IDENTITY, new Vec3(1, 0, 0), Vec3.ZERO));
        }
    }

    @Test
    void aTrailGoesThroughWhereAnObjectWasToWhereItIsAndFades() {
        ran("Red Ball");
        scene.jumpTo(4.5);
        assertThat(painted(Layer.TRAILS))
                .containsExactly(
                        "ball 4.500 0.000 0.000 r 0.500 ffe0504a",
                        "line 0.000 0.000 0.000 to 1.000 0.000 0.000 d4e0504a",
                        "line 1.000 0.000 0.000 to 2.000 0.000 0.000 d8e0504a",
                        "line 2.000 0.000 0.000 to 3.000 0.000 0.000 dbe0504a",
                        "line 3.000 0.000 0.000 to 4.000 0.000 0.000 dee0504a",
                        "line 4.000 0.000 0.000 to 4.500 0.000 0.000 e0e0504a");
    }

    @Test
    void ofALargeWorldTheTrailOfWhatIsSelectedIsDrawn() {
        ran("Red Ball");
        for (int id = 2; id <= 101; id++) {
            add(id, "B" + id, new Sphere(0.1));
        }
        scene.jumpTo(5);
        assertThat(painted(Layer.TRAILS)).noneMatch(line -> line.startsWith("line"));
        options.select(OptionalLong.of(1));
        assertThat(painted()).filteredOn(line -> line.startsWith("line")).hasSize(6);
    }

    @Test
    void aVelocityIsAnArrowToWhereTheObjectWouldBeInASecond() {
        ran("Red Ball");
        scene.jumpTo(5);
        // A head of 9 times the shaft's radius before its tip at x = 6.
        double head = 9 * 0.0016 * camera.height();
        assertThat(painted(Layer.VELOCITIES).subList(1, 3))
                .satisfiesExactly(
                        tube -> assertThat(tube).startsWith("tube 5.").endsWith("ff38c7c0"),
                        cone ->
                                assertThat(cone)
                                        .isEqualTo(
                                                String.format(
                                                        Locale.ROOT,
                                                        "cone %.3f 0.000 0.000 ff38c7c0",
                                                        6 - head)));
    }

    private void sensing(Sensor sensor) {
        scene.add(
                SeenObject.of(
                        1,
                        WorldObjectDefinition.named("Red Robot")
                                .mass(2)
                                .volume(new Sphere(0.5))
                                .orientation(Quat.ofAxisAngle(new Vec3(0, 0, 1), Math.PI / 2))
                                .component(sensor)
                                .build()));
    }

    @Test
    void aSonarIsAFanAsFarAsItReaches() {
        sensing(
                new RangeSonar(
                        "Sonar",
                        new Vec3(1, 0, 0),
                        Quat.IDENTITY,
                        5,
                        Math.PI / 2,
                        0,
                        10,
                        ScalarErrors.NONE,
                        new Sampling(1, 0, 0, 0)));
        // From the bow at y = 1, 45 degrees to either side.
        assertThat(painted(Layer.SENSORS))
                .contains(
                        "line 0.000 1.000 0.000 to -7.071 8.071 0.000 90b58df0",
                        "line 0.000 1.000 0.000 to 7.071 8.071 0.000 90b58df0")
                .hasSize(1 + 2 + 16);
    }

    @Test
    void aVelocityLogIsAConeOfFourBeamsDown() {
        sensing(
                new Dvl(
                        "Log",
                        Vec3.ZERO,
                        Quat.IDENTITY,
                        Math.PI / 4,
                        10,
                        1,
                        VectorErrors.NONE,
                        ScalarErrors.NONE,
                        new Sampling(1, 0, 0, 0)));
        assertThat(painted(Layer.SENSORS))
                .contains(
                        "line 0.000 0.000 0.000 to -5.000 5.000 -7.071 90b58df0",
                        "line 0.000 0.000 0.000 to 5.000 -5.000 -7.071 90b58df0")
                .hasSize(1 + 4 + 24);
    }

    @Test
    void theGridHasRoundSquaresAboutWhatIsLookedAt() {
        camera.aim(7.4, -2.6, -5, 12);
        assertThat(painted(Layer.GRID))
                .contains(
                        "line 7.000 -23.000 0.000 to 7.000 17.000 0.000 ff35505f",
                        "line -13.000 -3.000 0.000 to 27.000 -3.000 0.000 ff35505f",
                        "line 8.000 -23.000 0.000 to 8.000 17.000 0.000 ff35505f")
                .hasSize(2 * 41);
    }

    /** 1 m of amplitude along x: crests and troughs in turn, and level across. */
    @Test
    void wavesAreLinesThroughTheWater() {
        scene.setFields(List.of(new AiryWave(9, "Swell", 1, 8, 0, 0, OptionalDouble.empty(), 0)));
        camera.aim(0, 0, 0, 100);
        List<double[]> lines =
                painted(Layer.WATER).stream()
                        .filter(line -> line.startsWith("line"))
                        .map(line -> line.replaceAll("line | to| [0-9a-f]{8}$", "").split(" "))
                        .map(line -> Stream.of(line).mapToDouble(Double::parseDouble).toArray())
                        .toList();
        double number = 4 * Math.PI * Math.PI / 64 / 9.81;
        assertThat(lines)
                .hasSize(2 * 41 * 40)
                .allSatisfy(
                        end -> {
                            assertThat(end[2]).isCloseTo(Math.cos(number * end[0]), within(0.01));
                            assertThat(end[5]).isCloseTo(Math.cos(number * end[3]), within(0.01));
                        });
    }

    @Test
    void currentsAreArrowsAroundWhatIsLookedAt() {
        scene.setFields(List.of(new UniformCurrent(9, "Tide", new Vec3(0, 0.5, 0))));
        assertThat(painted(Layer.CURRENTS)).hasSize(2 * 81);
        assertThat(painted(Layer.WATER)).hasSize(2 * 81 + 1);
    }

    @Test
    void aCollisionFlashesFadingWithTime() {
        scene.meet(new Meeting(0, 1, 2, new Vec3(7, 8, 9), Vec3.ZERO));
        assertThat(painted(Layer.CONTACTS))
                .singleElement()
                .asString()
                .startsWith("ball 7.000 8.000");
        scene.jumpTo(0);
        scene.meet(new Meeting(-1, 1, 2, new Vec3(7, 8, 9), Vec3.ZERO));
        assertThat(painted()).isEmpty();
    }

    @Test
    void aWallBeforeTheRestIsSeenThroughAndOneBehindIsNot() {
        for (int side = -1; side <= 1; side += 2) {
            scene.add(
                    SeenObject.of(
                            10 + side,
                            WorldObjectDefinition.named("Wall " + side)
                                    .fixed()
                                    .volume(new Box(new Vec3(8, 0.1, 8)))
                                    .position(0, 5 * side, 0)
                                    .build()));
        }
        camera.aim(0, 0, 0, 20);
        StandardView.SIDE.apply(camera);
        assertThat(painted().get(0)).contains(" -5.000 ").endsWith("387c8288");
        assertThat(painted().get(1)).contains(" 5.000 ").endsWith("ff7c8288");
    }

    @Test
    void theCameraGoesWithWhatItFollows() {
        add(1, "Red Ball", new Sphere(0.5));
        options.follow(OptionalLong.of(1));
        assertThat(painted(Layer.LABELS)).contains("label Red Ball");
        assertThat(camera.target()).isEqualTo(new Vec3(1, 2, 3));
    }

    @Test
    void theNameOfWhatIsSelectedIsSeenInACrowd() {
        for (int id = 1; id <= 60; id++) {
            add(id, "B" + id, new Sphere(0.1));
        }
        options.select(OptionalLong.of(33));
        assertThat(painted(Layer.LABELS))
                .filteredOn(line -> line.startsWith("label"))
                .containsExactly("label B33");
    }

    @Test
    void ofNamesThatWouldLieUponOneAnotherTheNearestIsSeen() {
        camera.look(0, 0);
        camera.aim(0, 0, 0, 20);
        named(1, "Far", -2, 0);
        named(2, "Near", 2, 0.1);
        named(3, "Aside", -2, 5);
        assertThat(painted(Layer.LABELS))
                .filteredOn(line -> line.startsWith("label"))
                .containsExactly("label Near", "label Aside");
    }

    @Test
    void theNameOfWhatIsSelectedIsSeenBeforeANearerOne() {
        camera.look(0, 0);
        camera.aim(0, 0, 0, 20);
        named(1, "Far", -2, 0);
        named(2, "Near", 2, 0.1);
        options.select(OptionalLong.of(1));
        assertThat(painted(Layer.LABELS))
                .filteredOn(line -> line.startsWith("label"))
                .containsExactly("label Far");
    }

    private void named(long id, String name, double x, double y) {
        scene.add(
                SeenObject.of(
                        id,
                        WorldObjectDefinition.named(name)
                                .mass(2)
                                .volume(new Sphere(0.1))
                                .position(x, y, 0)
                                .build()));
    }
}
