package org.auvsim.examples.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.auvsml.framing.AuvsmlWriter;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.auvsml.message.sensing.SensorReadingMessage;
import org.auvsim.core.sensor.Sampling;
import org.auvsim.core.sensor.ScalarErrors;
import org.auvsim.core.sensor.Sensor;
import org.auvsim.core.sensor.SensorContract;
import org.auvsim.core.world.World;
import org.auvsim.core.world.WorldEvent;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

class InclinometerTest extends SensorContract {
    @Override
    protected Sensor sensor(Sampling sampling) {
        return new Inclinometer("Lean", new ScalarErrors(0.01, 0, 0.02), sampling);
    }

    /** A body that turns about its own x axis by 0.5 rad/s, its nose 30 degrees down. */
    private static final String SCENARIO =
            """
            <scenario>
              <world-object id="3" name="Spindle" mass="1">
                <sphere radius="0.5"/>
                <orientation w="0.9659258262890683" x="0" y="0.25881904510252074" z="0"/>
                <angular-velocity x="0.4330127018922193" y="0" z="-0.25"/>
                <inclinometer name="Lean"><sampling rate="10"/></inclinometer>
              </world-object>
            </scenario>
            """;

    private static World world() throws Exception {
        return ScenarioLoader.load(InclinometerTest.class.getClassLoader())
                .parse(SCENARIO.getBytes(UTF_8))
                .world();
    }

    private static List<WorldEvent.SensorRead> readings(World world, int steps) {
        List<WorldEvent.SensorRead> heard = new ArrayList<>();
        world.addListener(
                event -> {
                    if (event instanceof WorldEvent.SensorRead read) {
                        heard.add(read);
                    }
                });
        for (int i = 0; i < steps; i++) {
            world.advanceTimestep();
        }
        return heard;
    }

    @Test
    void itTellsHowItsBodyLeans() throws Exception {
        List<WorldEvent.SensorRead> heard = readings(world(), 20);

        assertThat(heard).hasSize(10);
        for (WorldEvent.SensorRead read : heard) {
            Inclination lean = (Inclination) read.reading();
            assertThat(lean.roll()).isCloseTo(0.5 * read.measuredAt(), within(1e-6));
            assertThat(lean.pitch()).isCloseTo(Math.PI / 6, within(1e-6));
        }
    }

    @Test
    void itsReadingsTravelAsMessages() {
        MessageCatalogue catalogue = MessageCatalogue.load(InclinometerTest.class.getClassLoader());

        byte[] written =
                new AuvsmlWriter(catalogue)
                        .write(
                                new SensorReadingMessage(
                                        2.5, 3, "Lean", 2.4, new Inclination(0.1, -0.2)));

        assertThat(new String(written, UTF_8))
                .contains("<inclination roll=\"0.1\" pitch=\"-0.2\"/>");
    }
}
