package org.auvsim.diagnosis.measured;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.reading.RunFiles;
import org.auvsim.diagnosis.reading.RunReader;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.shaking.SoundRuns;
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
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Dives of a small vehicle in five conditions, eight each: the drag of the model, and how much the
 * vehicle shakes, is by the normal ones; the condition of the others is to be found.
 */
@Tag("measured-data")
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class AuvDivesTest {
    /** So long (s) dives are fitted: all of it of several, two thirds of what is read of one. */
    private static final double FITTED = 5;

    private static final double OF_ONE = 1.5 * FITTED;

    private static final String WEIGHT = "buoyancy_weight";
    private static final String ZERO = "sensor_offset";
    private static final String PROPELLER = "propeller_imbalance";

    private final DataSet data = DataSet.named("auv-dives");
    private BelievedModel normal = data.model("auv.xml", "Diver");

    @BeforeAll
    void fitTheModelToTheNormalDives() throws Exception {
        normal = fitted(normalDives());
    }

    private List<Path> normalDives() throws IOException {
        return data.filesOf("Normal");
    }

    private RunFiles read(BelievedModel model, double until, List<Path> dives, List<Path> reference)
            throws DocumentException {
        RunReader reader = DataSet.reader(model, data.example("columns.xml")).between(0, until);
        return RunFiles.read(reader, dives, List.of(), reference);
    }

    private static Investigation investigation(
            BelievedModel model, RunFiles runs, String... causes) {
        return new Investigation(
                model,
                runs.fit(),
                runs.heldOut(),
                Library.named(List.of(causes), Library.of(model, runs.fit())),
                1,
                Progress.SILENT);
    }

    private BelievedModel fitted(List<Path> dives) throws DocumentException {
        BelievedModel guess = data.model("auv.xml", "Diver");
        RunFiles runs = read(guess, FITTED, dives, List.of());
        Diagnosis diagnosis = investigation(guess, runs, WEIGHT, "quadratic_drag").diagnose();
        assertThat(causes(diagnosis)).as(diagnosis.sentence()).containsExactly("quadratic_drag");
        return new BelievedModel(diagnosis.extended(), "Diver");
    }

    private Diagnosis condition(BelievedModel model, List<Path> dives, List<Path> reference)
            throws DocumentException {
        RunFiles runs = read(model, OF_ONE, dives, reference);
        return investigation(model, runs, WEIGHT, ZERO)
                .comparedWith(SoundRuns.of(model, runs.reference()))
                .diagnose();
    }

    private Diagnosis condition(List<Path> dives) throws IOException, DocumentException {
        return condition(normal, dives, normalDives());
    }

    private static List<String> causes(Diagnosis diagnosis) {
        return diagnosis.selected().stream().map(Finding::cause).toList();
    }

    private static double number(Diagnosis diagnosis) {
        return diagnosis.selected().getFirst().quantities().getFirst().value();
    }

    @ParameterizedTest
    @MethodSource("normalDives")
    void aNormalDiveRaisesNoAlarmBesideTheOthers(Path dive) throws Exception {
        List<Path> others = new ArrayList<>(normalDives());
        others.remove(dive);

        Diagnosis diagnosis = condition(fitted(others), List.of(dive), others);

        assertThat(diagnosis.verdict()).as(diagnosis.sentence()).isEqualTo(Verdict.NONE);
    }

    @Test
    void addedWeightIsFoundInItsDivesTogether() throws Exception {
        Diagnosis diagnosis = condition(data.filesOf("AddWeight"));

        assertThat(causes(diagnosis)).containsExactly(WEIGHT);
        assertThat(number(diagnosis)).isBetween(-4.0, -2.0);
        assertThat(diagnosis.sentence()).startsWith("A downward force is missing");
        assertThat(diagnosis.notices()).anyMatch(notice -> notice.contains("may shake it"));
    }

    @Test
    void aDepthSensorsZeroIsFoundInItsDivesTogether() throws Exception {
        Diagnosis diagnosis = condition(data.filesOf("PressureGain"));

        assertThat(causes(diagnosis)).containsExactly(ZERO);
        assertThat(number(diagnosis)).isCloseTo(-0.11, within(0.02));
    }

    @ParameterizedTest
    @ValueSource(strings = {"PropellerDamage_slight", "PropellerDamage_bad"})
    void aDamagedPropellerIsFoundInItsDivesTogether(String condition) throws Exception {
        Diagnosis diagnosis = condition(data.filesOf(condition));

        assertThat(causes(diagnosis)).containsExactly(PROPELLER);
        assertThat(number(diagnosis)).isBetween(2.5, 5.0);
        assertThat(diagnosis.sentence()).startsWith("The vehicle shakes");
    }

    /** Each dive by itself: 26 of 32, and no fewer of a condition than today. */
    @Test
    void mostDivesSayAloneWhatIsWrong() throws Exception {
        Map<String, Integer> named = new LinkedHashMap<>();
        named.put("AddWeight", named("AddWeight", WEIGHT));
        named.put("PressureGain", named("PressureGain", ZERO));
        named.put("PropellerDamage_bad", named("PropellerDamage_bad", PROPELLER));
        named.put("PropellerDamage_slight", named("PropellerDamage_slight", PROPELLER));

        assertThat(named.values().stream().mapToInt(Integer::intValue).sum())
                .as("%s", named)
                .isGreaterThanOrEqualTo(26);
        assertThat(named.get("AddWeight")).isGreaterThanOrEqualTo(7);
        assertThat(named.get("PressureGain")).isGreaterThanOrEqualTo(7);
        assertThat(named.get("PropellerDamage_bad")).isGreaterThanOrEqualTo(7);
        assertThat(named.get("PropellerDamage_slight")).isGreaterThanOrEqualTo(5);
    }

    /** How many dives of a condition are said to have this cause, and no other. */
    private int named(String condition, String cause) throws Exception {
        int count = 0;
        for (Path dive : data.filesOf(condition)) {
            count += causes(condition(List.of(dive))).equals(List.of(cause)) ? 1 : 0;
        }
        return count;
    }
}
