package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Path;

class VehicleTest {
    private static final Path VEHICLES = CommandLineHarness.EXAMPLES.resolve("vehicles");

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
                .contains("Righting      5.861 N m/rad, BG 0.01960 m")
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
