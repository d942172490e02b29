package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Path;

/** Thrusters without a column are told, but for those that a behavior of the scenario directs. */
class UndirectedTest {
    private static final String ROWS = Rov.rows("x,rudder", 20, i -> i + ",0");

    @TempDir private Path folder;

    @Test
    void aBatteryDirectsNoThruster() throws Exception {
        String scenario = Rov.with("<battery name='cells' capacity='9' charge='9'/>");

        assertThat(Rov.read(folder, scenario, ROWS).notices())
                .singleElement()
                .asString()
                .contains("column 'main': expected the level of the propulsor");
    }

    @Test
    void aFinThatIsFixedHasNoAngleToTell() throws Exception {
        String scenario =
                Rov.with(
                        "<fin name='wing' area='0.1' lift-slope='3' maximum-angle='0'>"
                                + "<span x='0' y='1' z='0'/></fin>");
        String rows = Rov.rows("x,main,rudder", 20, i -> i + ",0,0");

        assertThat(Rov.read(folder, scenario, rows).notices()).isEmpty();
    }

    @Test
    void aForceThatABehaviorAppliesDirectsNoThruster() throws Exception {
        String scenario =
                Rov.with(
                        "<go-to-point name='home' force='1'><target x='9' y='0'"
                                + " z='0'/></go-to-point>");

        assertThat(Rov.read(folder, scenario, ROWS).notices())
                .singleElement()
                .asString()
                .contains("column 'main'");
    }

    @Test
    void aScheduleDirectsItsThrusterAndNoFin() throws Exception {
        String scenario =
                Rov.with(
                        "<propulsor-schedule name='plan' propulsor='main'>"
                                + "<timed-level at='0' level='1'/></propulsor-schedule>");

        assertThat(Rov.read(folder, scenario, ROWS).notices()).isEmpty();
        assertThat(Rov.read(folder, scenario, Rov.rows("x", 20, i -> "" + i)).notices())
                .singleElement()
                .asString()
                .contains("column 'rudder': expected the angle of the fin");
    }
}
