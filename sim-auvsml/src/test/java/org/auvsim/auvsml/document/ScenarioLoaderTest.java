package org.auvsim.auvsml.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.FeedbackTimestepping.AsynchronousFeedbackTimestepper;
import org.auvsim.auvsml.document.FeedbackTimestepping.AwaitedClient;
import org.auvsim.auvsml.document.FeedbackTimestepping.SimpleFixedTimeFeedbackTimestepper;
import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.dynamics.Rk4;
import org.auvsim.core.effect.Damping;
import org.auvsim.core.effect.Gravity;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.entity.WorldObjectDefinition;
import org.auvsim.core.field.UniformCurrent;
import org.auvsim.core.math.Vec3;
import org.auvsim.core.sensor.Datum;
import org.auvsim.core.step.AllPairsPartitioner;
import org.auvsim.core.step.BisectionFinder;
import org.auvsim.core.step.EventStepper;
import org.auvsim.core.step.MaximumSpeedRestricter;
import org.auvsim.core.step.SnapshotStepper;
import org.auvsim.core.volume.Box;
import org.auvsim.core.volume.Sphere;
import org.auvsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

class ScenarioLoaderTest {
    private static final String TANK =
            """
            <?xml version="1.0" encoding="UTF-8"?>
            <!-- everything that a scenario can have -->
            <scenario start-time="1.5">
              <time-step delta="0.01"/>
              <snapshot-stepper>
                <maximum-speed-restricter speed="20"/>
                <all-pairs-partitioner/>
              </snapshot-stepper>
              <simple-fixed-time-feedback-timestepper wait="0.02">
                <client name="robot"/>
              </simple-fixed-time-feedback-timestepper>
              <feedback-processor override="VectorAdjustmentFeedbackHandler"/>
              <released-object forces="brake" deceleration="0.2"/><uniform-current id="1" name="tide"><velocity x="0.3" y="0" z="0"/></uniform-current><datum latitude="36.6" longitude="-121.9" altitude="-5"/>
              <world-object id="47" name="Juggernaut" mass="30" restitution="0.5">
                <box><size x="1.2" y="0.4" z="0.3"/></box>
                <position x="1" y="2" z="-3"/>
                <force name="lift"><vector x="0" y="0" z="10"/></force>
                <damping><linear x="1" y="2" z="3"/></damping>
                <gravity/>
                <propulsor name="Aft Thruster" maximum-thrust="20"/>
              </world-object>
              <world-object name="Rock" fixed="1"><sphere radius="0.5"/></world-object>
            </scenario>
            """;

    private final ScenarioLoader loader =
            ScenarioLoader.load(ScenarioLoaderTest.class.getClassLoader());

    @Test
    void readsHowFeedbackProcessorsWork() throws Exception {
        String scenario =
                """
                <scenario>
                  <feedback-processor>
                    <vector-adjustment-feedback-handler momentum="as-thesis"/>
                    <kalman-filter-feedback-handler acceleration="0.02">
                      <initial position="5" angle="0.1" velocity="1" angular-velocity="0.1"/>
                    </kalman-filter-feedback-handler>
                  </feedback-processor>
                </scenario>
                """;
        assertThat(loader.parse(scenario.getBytes(UTF_8)).feedbackProcessor())
                .contains(
                        new FeedbackProcessorChoice(
                                Optional.empty(),
                                List.of(
                                        new FeedbackProcessing.VectorAdjustmentFeedbackHandler(
                                                MomentumRule.AS_THESIS),
                                        new FeedbackProcessing.KalmanFilterFeedbackHandler(
                                                0.02,
                                                0.1,
                                                new Deviations(0.1, 0.02, 0.05, 0.01),
                                                new Deviations(5, 0.1, 1, 0.1)))));
    }

    @Test
    void readsAllThatAScenarioCanHave() throws Exception {
        Scenario scenario = loader.parse(TANK.getBytes(UTF_8));

        assertThat(scenario)
                .isEqualTo(
                        new Scenario(
                                1.5,
                                false,
                                false,
                                0,
                                new TimeStep(0.01),
                                new SnapshotStepper(
                                        new MaximumSpeedRestricter(20),
                                        new AllPairsPartitioner(),
                                        BisectionFinder.standard()),
                                new Rk4(),
                                new SimpleFixedTimeFeedbackTimestepper(
                                        0.02, List.of(new AwaitedClient("robot"))),
                                Optional.of(
                                        new FeedbackProcessorChoice(
                                                "VectorAdjustmentFeedbackHandler")),
                                Optional.of(new ReleasedObject(ReleasedForces.BRAKE, 0.2, 0.5)),
                                Optional.of(new Datum(36.6, -121.9, -5)),
                                List.of(new UniformCurrent(1, "tide", new Vec3(0.3, 0, 0))),
                                List.of(
                                        WorldObjectDefinition.named("Juggernaut")
                                                .id(47)
                                                .mass(30)
                                                .restitution(0.5)
                                                .volume(new Box(new Vec3(1.2, 0.4, 0.3)))
                                                .position(1, 2, -3)
                                                .force(
                                                        NamedForce.direct(
                                                                "lift",
                                                                Frame.WORLD,
                                                                new Vec3(0, 0, 10)))
                                                .effect(
                                                        new Damping(
                                                                new Vec3(1, 2, 3),
                                                                Vec3.ZERO,
                                                                Vec3.ZERO,
                                                                Vec3.ZERO))
                                                .effect(new Gravity(9.80665))
                                                .component(
                                                        new Propulsor(
                                                                "Aft Thruster",
                                                                20,
                                                                0,
                                                                Vec3.ZERO,
                                                                new Vec3(1, 0, 0)))
                                                .build(),
                                        WorldObjectDefinition.named("Rock")
                                                .fixed()
                                                .volume(new Sphere(0.5))
                                                .build())));
    }

    @Test
    void buildsTheWorld() throws Exception {
        World world = loader.parse(TANK.getBytes(UTF_8)).world();

        assertThat(world.time()).isEqualTo(1.5);
        assertThat(world.object("Juggernaut").id()).isEqualTo(47);
        assertThat(world.object("Rock").id()).isEqualTo(2);
    }

    @Test
    void overlapsAreLetBeIfTheScenarioSaysSo() throws Exception {
        String text =
                TANK.replace("<position x=\"1\" y=\"2\" z=\"-3\"/>", "")
                        .replace("start-time", "allow-overlaps=\"1\" start-time");

        assertThat(loader.parse(text.getBytes(UTF_8)).world().overlaps(2)).containsExactly(47L);
    }

    @Test
    void anEmptyWorldHasTheDefaults() throws Exception {
        Scenario scenario = loader.parse("<scenario/>".getBytes(UTF_8));

        assertThat(scenario.timeStep()).isEqualTo(new TimeStep(0.05));
        assertThat(scenario.stepper()).isEqualTo(EventStepper.standard());
        assertThat(scenario.feedbackTimestepping())
                .isEqualTo(new AsynchronousFeedbackTimestepper());
        assertThat(scenario.world().time()).isZero();
    }

    @ParameterizedTest(name = "{2}")
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            textBlock =
                    """
                    mass="30"             | mass="-30"          | line 14, column 3: mass must be
                    mass="30"             | mass="NaN"          | line 14, column 43: expected a finite number, but found 'NaN' at scenario/world-object@mass
                    mass="30"             | mass="x"            | line 14, column 43: expected a finite number, but found 'x' at scenario/world-object@mass
                    mass="30"             | ``                  | line 14, column 3: world object 'Juggernaut' needs a mass
                    mass="30"             | mas="30"            | line 14, column 43: <world-object> has no attribute 'mas'; the nearest known name is 'mass'
                    name="Rock"           | name="Juggernaut"   | line 22, column 17: the name 'Juggernaut' is that of the <world-object> in line 14
                    name="Rock"           | name="a" id="47"    | line 22, column 26: the id '47' is that of the <world-object> in line 14
                    delta="0.01"          | delta="0"           | line 4, column 3: the time step must be 1.0E-9 s or more, but is 0.0 s
                    delta="0.01"          | delta="-1"          | line 4, column 3: the time step must be 1.0E-9 s or more, but is -1.0 s
                    delta="0.01"          | delta="1e-300"      | line 4, column 3: the time step must be 1.0E-9 s or more, but is 1.0E-300 s
                    start-time="1.5"      | start-time="1e15"   | line 3, column 1: a time step of 0.01 s leaves the start time of 1.0E15 s as it is; begin earlier, or take a longer step
                    <sphere radius="0.5"/>| ``                  | line 22, column 3: <world-object> needs a volume: one of the elements box
                    <sphere radius="0.5"/>| <compound/>         | line 22, column 39: a compound needs at least one part
                    <sphere radius="0.5"/>| <height-map spacing="1"><row heights="0 x"/></height-map> | line 22, column 68: expected finite numbers with blanks between them, but found '0 x'
                    <sphere radius="0.5"/>| <height-map spacing="1"><row heights="0 1"/><row heights="0"/></height-map> | line 22, column 39: row 2 of a height map has 1 heights, but row 1 has 2
                    <gravity/>            | <gravty/>           | line 19, column 5: unknown element 'gravty'; the nearest known name is 'gravity'
                    <gravity/>            | <gravity>           | line 21, column 16: unexpected close tag
                    <snapshot-stepper>    | <event-stepper/><octree-partitioner/><snapshot-stepper> | line 5, column 19: <octree-partitioner> belongs inside <snapshot-stepper>, but is inside <scenario>
                    <snapshot-stepper>    | <event-stepper><bisection-finder/></event-stepper><snapshot-stepper> | line 5, column 18: <bisection-finder> belongs inside <snapshot-stepper>, but is inside <event-stepper>
                    start-time="1.5"      | start-time="1.5" bounding-spheres="1"><world-object name="Ground" fixed="1"><half-space/></world-object | line 3, column 1: 'Ground' has no bounding sphere, as its volume has no end
                    <position x="1" y="2" z="-3"/> | ``         | line 22, column 3: 'Rock' overlaps 'Juggernaut' of line 14 by 0.650 m; move them apart or set allow-overlaps
                    wait="0.02"           | wait="-1"           | line 9, column 3: the wait for feedback must be above 0 s
                    <scenario start-time  | <scene start-time   | line 23, column 10: unexpected close tag
                    """)
    void aFaultIsOneSentenceWithItsPlace(String right, String wrong, String sentence) {
        String text = TANK.replace(right, wrong);
        assertThat(text).isNotEqualTo(TANK);

        assertThatThrownBy(() -> loader.parse(text.getBytes(UTF_8)))
                .hasMessageStartingWith(sentence);
    }

    @Test
    void reportsAllFaultsOfAText() {
        String text =
                """
                <scenario start-time="later">
                  <time-step/>
                  <world-object name="a" mass="1"><sphere radius="-1"/></world-object>
                  <world-object name="a" mass="1"/>
                </scenario>
                """;

        assertThatThrownBy(() -> loader.parse(text.getBytes(UTF_8)))
                .isInstanceOfSatisfying(
                        AuvsmlException.class,
                        e ->
                                assertThat(e.faults())
                                        .extracting(fault -> fault.line() + ":" + fault.column())
                                        .containsExactly("1:11", "3:35", "4:17", "2:3", "4:3"));
    }

    @Test
    void aFilesFaultNamesTheFile(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("tank.xml");

        assertThatThrownBy(() -> loader.load(file))
                .isInstanceOf(DocumentException.class)
                .hasMessage(file + ": there is no such file");
        assertThatThrownBy(() -> loader.load(folder))
                .hasMessage(folder + " is a folder; expected a file, name one in it");

        Files.writeString(file, "<auvsml/>");
        assertThatThrownBy(() -> loader.load(file))
                .hasMessage(
                        file
                                + ":1:1: expected the root element <scenario>,"
                                + " but found <auvsml> at auvsml");

        Files.writeString(file, "mass: 3");
        assertThatThrownBy(() -> loader.load(file))
                .isInstanceOf(DocumentException.class)
                .hasMessageStartingWith(file + ":1:1: ");

        Files.writeString(file, TANK);
        assertThat(loader.load(file)).isEqualTo(loader.parse(TANK.getBytes(UTF_8)));
    }

    @Test
    void aScenarioIsWrittenAsItIsRead() throws Exception {
        Scenario scenario = loader.parse(TANK.getBytes(UTF_8));

        String written = AuvsmlMapper.load(getClass().getClassLoader()).encode(scenario);

        assertThat(loader.parse(written.getBytes(UTF_8))).isEqualTo(scenario);
    }

    @Test
    void moreThanAMebibyteIsRefusedUnread(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("large.xml");
        Files.writeString(file, "<scenario>" + " ".repeat(1 << 20) + "</scenario>");

        assertThatThrownBy(() -> loader.load(file))
                .hasMessageContaining("expected at most 1048576 bytes, but there are more");
    }
}
