package org.auvsim.diagnosis.report;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.auvsml.document.Validation;
import org.auvsim.auvsml.mapping.MessageCatalogue;
import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

class ExtendedScenarioTest {
    private static final ClassLoader LOADER = ExtendedScenarioTest.class.getClassLoader();
    @TempDir private Path folder;

    private Path written(Diagnosis diagnosis) throws Exception {
        Report.write(diagnosis, folder);
        return folder.resolve("extended-scenario.xml");
    }

    @Test
    void itIsReadAsWhatWasFound() throws Exception {
        Diagnosis diagnosis = Diagnoses.explained();
        Path file = written(diagnosis);
        assertThat(ScenarioLoader.load(LOADER).load(file)).isEqualTo(diagnosis.extended());
        assertThat(new Validation(MessageCatalogue.load(LOADER)).faults(file)).isEmpty();
    }

    @Test
    void itSaysWhatWasAddedAndWhy() throws Exception {
        assertThat(
                        Files.readString(
                                written(
                                        Diagnoses.explained(
                                                List.of(
                                                        Diagnoses.QUADRATIC_DRAG,
                                                        Diagnoses.THRUST,
                                                        Diagnoses.CURRENT),
                                                100,
                                                List.of()))))
                .startsWith(
                        "<!--\n  A diagnosis of 'sledge' (seed 42).\n  Quadratic drag is missing")
                .contains(
                        """
                          What was added to the model as it was believed:
                          - quadratic_drag: k = 12.4 +- 0.3 kg/m; quadratic drag is missing
                          - thruster_gain (port): factor = 0.800 +- 0.004 times; the thrust of 'port' is wrong
                          - current_constant: u = (0.200 +- 0.004, -0.100 +- 0.003, 0.000 +- 0.002) m/s; a constant current is missing
                        -->
                        <scenario\
                        """);
    }

    @Test
    void whatSensorsDoIsInNoScenario() throws Exception {
        Finding bias =
                new Finding(
                        "sensor_bias",
                        Optional.empty(),
                        List.of(new Quantity("yaw", "rad", 0.1)),
                        List.of(0.01),
                        0.4,
                        false);
        assertThat(
                        Files.readString(
                                written(
                                        Diagnoses.explained(
                                                List.of(Diagnoses.QUADRATIC_DRAG, bias),
                                                100,
                                                List.of()))))
                .contains(
                        """
                          What was found beside that, which no scenario has:
                          - sensor_bias: yaw = 0.100 +- 0.010 rad; the measured heading is off
                        -->
                        """)
                .doesNotContain(
                        "- quadratic_drag: k = 12.4 +- 0.3 kg/m; quadratic drag is missing\n-->");
    }

    @Test
    void aNullSaysThatNothingWasAdded() throws Exception {
        Diagnosis none = Diagnoses.none();
        Path file = written(none);
        assertThat(Files.readString(file))
                .contains("Nothing was added: this is the model as it was believed.\n-->");
        assertThat(ScenarioLoader.load(LOADER).load(file)).isEqualTo(none.extended());
    }

    @Test
    void whatExplainsNothingIsWrittenAsideUntilSomethingIsExplained() throws Exception {
        Diagnosis diagnosis = Diagnoses.unexplained();
        Path extended = written(diagnosis);
        Path approximate = folder.resolve("approximate-scenario.xml");

        assertThat(Files.readString(extended)).contains("Nothing was added");
        assertThat(Files.readString(approximate))
                .contains("An approximation, no finding")
                .contains("- quadratic_drag: k = 12.4 kg/m;");
        assertThat(ScenarioLoader.load(LOADER).load(approximate))
                .isEqualTo(diagnosis.conclusion().approximation().orElseThrow().scenario());

        written(Diagnoses.explained());
        assertThat(approximate).doesNotExist();
    }

    @ParameterizedTest
    @ValueSource(strings = {"a--b-->", "a---b", "----", "a-"})
    void namesEndNoComment(String name) throws Exception {
        Diagnosis diagnosis = Diagnoses.renamed(Diagnoses.none(), name);
        assertThat(ScenarioLoader.load(LOADER).load(written(diagnosis)))
                .isEqualTo(diagnosis.extended());
    }
}
