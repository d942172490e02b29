package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

class VehicleTest {
    private static final Path VEHICLES = CommandLineHarness.EXAMPLES.resolve("vehicles");
    private static final String NEUTRAL = "volume=\"0.01\"";

    /** 10 kg, 2 N ahead against 1 N s^2/m^2; heights of its centres, and what else acts on it. */
    private static final String SLED =
            """
            <scenario>
              <world-object name="Sled" mass="10"><box><size x="1" y="1" z="1"/></box>
                <inertia xx="0.5" yy="0.5" zz="0.5"/>
                <centre-of-mass x="0" y="0" z="%s"/>
                <gravity/><buoyancy volume="0.01" density="1000"><centre x="0" y="0" z="%s"/></buoyancy>
                <damping><quadratic x="1" y="1" z="1"/></damping>
                %s
                <propulsor name="Screw" maximum-thrust="2"/>
              </world-object>
            </scenario>
            """;

    @TempDir private Path folder;
    private CommandLineHarness auvsim;

    @BeforeEach
    void begin() {
        auvsim = new CommandLineHarness(folder);
    }

    /** Ten times the drag of strip theory in sway, twenty in pitch: so it is printed. */
    @Test
    void theSheetOfTheTorpedoFindsTheConflictsOfItsPublishedNumbers() {
        assertThat(auvsim.run("vehicle", VEHICLES.resolve("remus100.xml"))).isZero();
        assertThat(auvsim.out())
                .contains("Full thrust   ahead 1.54, astern 1.54, to port -, up -, down - (m/s)")
                .contains("Righting      5.998 N m/rad, BG 0.01960 m")
                .contains("unstable sideways")
                .contains("- Buoyancy is 7.0 N more than weight (2.3 %): it rises.")
                .contains("- The water resists sway at 1 m/s with 1324 N but heave with 144.7 N")
                .contains("- Drag in sway is 1324 N at 1 m/s, 9.5 times the 140 of strip theory.")
                .contains("- Drag in pitch is 191.6 N m at 1 rad/s, 20 times")
                .doesNotContain("Added mass in sway")
                .doesNotContain("Drag in heave");
    }

    @Test
    void theSheetOfTheRovHasItsSpeedsAndThrusters() {
        assertThat(auvsim.run("vehicle", VEHICLES.resolve("bluerov2-heavy.xml"))).isZero();
        assertThat(auvsim.out())
                .contains("ahead 0.734, astern 0.734")
                .contains(
                        "Thrusters     8, rank 6, independent: surge, sway, heave, roll, pitch,"
                                + " yaw")
                .contains("- Buoyancy is 1.0 N less than weight (0.7 %): it sinks.");
    }

    /** What is left of weights that are taken off is not taken for a drive. */
    @Test
    void aBodyOnWhichWaterHasNoHoldGetsNoEnergyFromIt() {
        for (String scenario : List.of("demo.xml", "stack.xml", "slope.xml")) {
            auvsim.run("vehicle", VEHICLES.resolve("../scenarios/" + scenario));
        }
        assertThat(auvsim.out()).doesNotContain("gives it energy");
    }

    @Test
    void whatIsWrongOfAnInventedVehicleIsSaid() throws IOException {
        Path file =
                auvsim.file(
                        "a.xml",
                        """
                        <scenario>
                          <world-object name="Rock" fixed="1"><sphere radius="1"/>
                            <position x="9" y="0" z="0"/></world-object>
                          <world-object name="Odd" mass="10">
                            <capsule radius="0.1" length="0.8"/>
                            <inertia xx="3" yy="1" zz="1"/>
                            <centre-of-mass x="0.1" y="0" z="0.05"/>
                            <gravity/><buoyancy volume="0.02"/>
                            <added-mass><linear x="0.5" y="100" z="20"/></added-mass>
                            <damping><quadratic x="1" y="80" z="200"/></damping>
                          </world-object>
                        </scenario>
                        """);

        assertThat(auvsim.run("vehicle", file)).isZero();
        assertThat(auvsim.out())
                .startsWith("Odd (body axes")
                .contains("- No body has these moments of inertia: 3.00 kg m^2 is more than")
                .contains("- Buoyancy is 103.0 N more than weight")
                .contains("- Nothing rights it: the centre of buoyancy is 0.05000 m below")
                .contains("- The centre of buoyancy is -0.1000 m ahead and 0.000 m to port")
                .contains("- Added mass in sway is 100 kg, but strip theory says")
                .contains("- The water resists sway at 1 m/s with 80.00 N but heave with 200.0 N");
    }

    /** Its speeds and stability are those of the vehicle, not of what it hangs on. */
    @Test
    void whatTiesItToAPlaceChangesNothing() throws IOException {
        String free = sheet(SLED.formatted(0.0, 0.05, ""));
        String tied =
                sheet(
                        SLED.formatted(
                                0.0,
                                0.05,
                                """
                                <mooring length="1" stiffness="50" damping="20">
                                  <anchor x="0" y="0" z="0"/></mooring>
                                <central-force force="7"><target x="9" y="0" z="0"/></central-force>
                                """));

        assertThat(free).contains("Full thrust   ahead 1.41, astern 1.41");
        assertThat(tied).isEqualTo(free);
    }

    /** Free, it swings about its centre of mass: 2 pi sqrt(0.5 kg m^2 / (98.0665 N x 0.05 m)). */
    @ParameterizedTest
    @ValueSource(doubles = {0, 1, -1})
    void itsStabilityDoesNotDependOnTheOrigin(double height) throws IOException {
        assertThat(sheet(SLED.formatted(height, height + 0.05, "")))
                .contains("Righting      4.903 N m/rad, BG 0.05000 m; rolls in 2.01 s, pitches in")
                .doesNotContain("Nothing rights it");
        String volume = "volume=\"0.0103\"";
        assertThat(sheet(SLED.formatted(height, height - 0.01, "").replace(NEUTRAL, volume)))
                .doesNotContain("Righting")
                .contains("- Nothing rights it: the centre of buoyancy is 0.01000 m below");
        String buoy = SLED.formatted(height, height + 0.01, "").replace(NEUTRAL, "volume=\"1\"");
        assertThat(sheet(buoy)).contains("BG 0.01000 m\n").doesNotContain("rolls in");
    }

    private String sheet(String scenario) throws IOException {
        CommandLineHarness alone = new CommandLineHarness(folder);
        assertThat(alone.run("vehicle", auvsim.file("sled.xml", scenario)))
                .as(alone.err())
                .isZero();
        return alone.out();
    }

    @Test
    void aMatrixThatIsNotSymmetricIsRefused() throws IOException {
        Path file =
                auvsim.file(
                        "a.xml",
                        """
                        <scenario>
                          <world-object name="Odd" mass="10"><sphere radius="0.1"/>
                            <added-mass><linear x="5" y="5" z="5"/><angular x="5" y="5" z="5"/>
                              <term row="SWAY" column="YAW" value="1.0"/>
                              <term row="YAW" column="SWAY" value="-1.0"/></added-mass>
                          </world-object>
                        </scenario>
                        """);

        assertThat(auvsim.run("vehicle", file)).isEqualTo(2);
        assertThat(auvsim.err()).contains("an added mass matrix is symmetric, but YAW by SWAY is");
    }

    @Test
    void whatIsNoVehicleIsExplained() {
        Path tank = CommandLineHarness.EXAMPLES.resolve("scenarios").resolve("tank.xml");
        assertThat(auvsim.run("vehicle", tank, "--body", "Nautilus")).isEqualTo(2);
        assertThat(auvsim.err()).contains("there is no body 'Nautilus'; there are [AUV-1701, ");
        assertThat(auvsim.run("vehicle", tank, "--body", "Floor")).isEqualTo(2);
        assertThat(auvsim.err()).contains("'Floor' is fixed or has no end and so is no vehicle");
        assertThat(auvsim.run("vehicle", tank, "--body", "Red Ball")).isZero();
        assertThat(auvsim.out()).startsWith("Red Ball");
    }
}
