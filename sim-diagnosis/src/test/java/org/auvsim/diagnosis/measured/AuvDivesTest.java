package org.auvsim.diagnosis.measured;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.reading.RunFiles;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Verdict;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Dives of a small vehicle in five conditions, eight each: the drag of the model is by the normal
 * ones, the condition of the others is to be found. What these dives do not show is not named.
 */
@Tag("measured-data")
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class AuvDivesTest {
    /** After this (s) the fastest dive touches the floor. */
    private static final double UNTIL = 3.6;

    private static final String WEIGHT = "buoyancy_weight";
    private static final String ZERO = "sensor_offset";

    private final DataSet data = DataSet.named("auv-dives");
    private BelievedModel normal = data.model("auv.xml", "Diver");

    @BeforeAll
    void fitTheModelToTheNormalDives() throws Exception {
        normal = fitted(data.filesOf("Normal"));
    }

    private List<Path> normalDives() throws IOException {
        return data.filesOf("Normal");
    }

    private BelievedModel fitted(List<Path> dives) throws DocumentException {
        BelievedModel guess = data.model("auv.xml", "Diver");
        Diagnosis diagnosis = diagnosis(guess, dives, WEIGHT, "quadratic_drag");
        assertThat(causes(diagnosis)).as(diagnosis.sentence()).containsExactly("quadratic_drag");
        return new BelievedModel(diagnosis.extended(), "Diver");
    }

    private Diagnosis diagnosis(BelievedModel model, List<Path> dives, String... causes)
            throws DocumentException {
        RunFiles runs =
                RunFiles.read(
                        DataSet.reader(model, data.example("columns.xml")).between(0, UNTIL),
                        dives,
                        List.of());
        return new Investigation(
                        model,
                        runs.fit(),
                        runs.heldOut(),
                        Library.named(List.of(causes), Library.of(model, runs.fit())),
                        1,
                        Progress.SILENT)
                .diagnose();
    }

    private Diagnosis condition(List<Path> dives) throws DocumentException {
        return diagnosis(normal, dives, WEIGHT, ZERO);
    }

    private static List<String> causes(Diagnosis diagnosis) {
        return diagnosis.selected().stream().map(Finding::cause).toList();
    }

    private static double number(Diagnosis diagnosis) {
        return diagnosis.selected().getFirst().quantities().getFirst().value();
    }

    @ParameterizedTest
    @MethodSource("normalDives")
    void aNormalDiveRaisesNoAlarmToAModelFittedToTheOthers(Path dive) throws Exception {
        List<Path> others = new ArrayList<>(normalDives());
        others.remove(dive);

        Diagnosis diagnosis = diagnosis(fitted(others), List.of(dive), WEIGHT, ZERO);

        assertThat(diagnosis.verdict()).as(diagnosis.sentence()).isEqualTo(Verdict.NONE);
    }

    @Test
    void addedWeightIsFoundInItsDivesTogether() throws Exception {
        Diagnosis diagnosis = condition(data.filesOf("AddWeight"));

        assertThat(causes(diagnosis)).containsExactly(WEIGHT);
        assertThat(number(diagnosis)).isBetween(-4.0, -1.0);
        assertThat(diagnosis.sentence()).startsWith("A downward force is missing");
    }

    @Test
    void aDepthSensorsZeroIsFoundInItsDivesTogetherAndInEachAlone() throws Exception {
        List<Path> dives = data.filesOf("PressureGain");
        Diagnosis together = condition(dives);

        assertThat(causes(together)).containsExactly(ZERO);
        assertThat(number(together)).isCloseTo(-0.11, within(0.02));
        for (Path dive : dives) {
            Diagnosis alone = condition(List.of(dive));
            assertThat(causes(alone)).as(dive.toString()).containsExactly(ZERO);
            assertThat(number(alone)).isBetween(-0.2, -0.05);
        }
    }

    /** A condition that leaves less than normal dives differ by is not guessed. */
    @ParameterizedTest
    @ValueSource(strings = {"PropellerDamage_slight", "PropellerDamage_bad"})
    void whatTheDivesDoNotShowIsNotNamed(String condition) throws Exception {
        Diagnosis together = condition(data.filesOf(condition));

        assertThat(together.verdict()).as(together.sentence()).isEqualTo(Verdict.NONE);
    }

    @Test
    void fewDivesWithAddedWeightShowItAlone() throws Exception {
        List<String> named = new ArrayList<>();
        for (Path dive : data.filesOf("AddWeight")) {
            named.addAll(causes(condition(List.of(dive))));
        }

        assertThat(named).filteredOn(WEIGHT::equals).hasSizeGreaterThanOrEqualTo(3);
        assertThat(named).filteredOn(ZERO::equals).hasSizeLessThanOrEqualTo(1);
    }
}
