package org.auvsim.cli.demo;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.server.simulator.Simulator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** The whole way: a server, a robot over a real socket, feedback, the picture. */
class FlightTest {
    private static final double DURATION = 6;

    @Test
    void feedbackBringsTheSimulationToTheRobot(@TempDir Path folder) throws Exception {
        Track free = fly("free", Optional.empty());
        Track corrected = fly("corrected", Optional.of("DirectPositionChangeFeedbackHandler"));

        assertThat(free.corrections()).isZero();
        assertThat(corrected.corrections()).isPositive();
        assertThat(corrected.rmsError()).isLessThan(free.rmsError() / 2);
        assertThat(DemoReport.write(folder, List.of(free, corrected), corrected, "a drag"))
                .content()
                .contains("<td>corrected</td><td>" + corrected.corrections() + "</td>")
                .contains(DemoReport.WHY_ALIKE)
                .contains("a drag");
        assertThat(folder.resolve("demo.png")).isNotEmptyFile();
    }

    private static Track fly(String name, Optional<String> handler) throws Exception {
        Scenario scenario =
                ScenarioLoader.load(FlightTest.class.getClassLoader())
                        .load(Path.of("../examples/scenarios/demo.xml"));
        Track track = new Track(name);
        LiveTable table = new LiveTable(new PrintWriter(new StringWriter()));
        table.begin(track);
        Optional<Sensors> sensors =
                handler.map(of -> new Sensors(of, Demonstration.FEEDBACK_EVERY, false));
        new Flight(Simulator.of(scenario), new FlightPlan(), sensors, track, table)
                .fly(_ -> DURATION);
        return track;
    }
}
