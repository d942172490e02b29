package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;

/** What {@code auvsim diagnose} comes to. */
class DiagnoseTest extends DiagnosedFalls {
    /** By all causes that there are, and by few: genetics takes its time. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "--method shooting",
                "--causes linear_drag --parts 1 --ignore-others",
                "--causes linear_drag --from 0.2 --until 1.8 --body Ball",
                "--method genetic --causes linear_drag,quadratic_drag,buoyancy_weight"
            })
    void aModelThatIsRightHasNothingMissing(String options) throws IOException {
        Path report = folder.resolve("report");
        List<Object> arguments = new ArrayList<>(List.of(options.split(" ", -1)));
        arguments.addAll(List.of("--out", report, "--fail-on-discrepancy"));

        int code = diagnoseFalls(BALL, 0, arguments.toArray());

        assertThat(code).as(auvsim.err()).isZero();
        assertThat(auvsim.out())
                .containsPattern(
                        "Causes looked for: [1-9][0-9]*; (sets of them that were fitted: [1-9]|none"
                                + " of them promised enough to be fitted[.])")
                .contains("report.html");
        assertThat(report.resolve("report.html")).isNotEmptyFile();
        assertThat(report.resolve("diagnosis.json")).content().contains("\"verdict\" : \"none\"");
        assertThat(auvsim.run("validate", report.resolve("extended-scenario.xml"))).isZero();
    }

    /** A swaying that the only cause which is looked for cannot explain. */
    @ParameterizedTest
    @CsvSource({"--seed=1, 0", "--fail-on-discrepancy, 1"})
    void whatNothingExplainsEndsLikeAnyVerdictUnlessItIsToFail(String option, int expected)
            throws IOException {
        Path report = folder.resolve("report");

        int code = diagnoseFalls(BALL, 0.3, "--causes", "linear_drag", "--out", report, option);

        assertThat(code).as(auvsim.err()).isEqualTo(expected);
        assertThat(report.resolve("diagnosis.json"))
                .content()
                .contains("\"verdict\" : \"unexplained\"");
    }

    @Test
    void whatIsExplainedIsADiscrepancy() throws IOException {
        String model = BALL.replace("<gravity/>", "<gravity acceleration=\"9\"/>");
        Path report = folder.resolve("report");

        int code =
                diagnoseFalls(
                        model,
                        0,
                        "--causes",
                        "buoyancy_weight",
                        "--out",
                        report,
                        "--fail-on-discrepancy");

        assertThat(code).as(auvsim.err()).isEqualTo(1);
        assertThat(auvsim.out()).startsWith("A downward force is missing");
        nothingIsLeftToSayOf(report.resolve("extended-scenario.xml"));
    }

    private void nothingIsLeftToSayOf(Path extended) throws IOException {
        assertThat(auvsim.run("run", extended, "--until", "1")).as(auvsim.err()).isZero();
        Path again = folder.resolve("again");
        assertThat(
                        diagnoseFalls(
                                Files.readString(extended),
                                0,
                                "--causes",
                                "buoyancy_weight",
                                "--out",
                                again,
                                "--fail-on-discrepancy"))
                .as(auvsim.err())
                .isZero();
        assertThat(again.resolve("diagnosis.json")).content().contains("\"verdict\" : \"none\"");
    }

    @Test
    void withoutHeldOutRunsOneOfThemIsHeldOut() throws IOException {
        Path report = folder.resolve("report");
        int code =
                diagnose(
                        BALL,
                        "--causes",
                        "linear_drag",
                        "--out",
                        report,
                        "--fit",
                        fall("one.csv", 0),
                        fall("two.csv", 1),
                        fall("three.csv", 2));

        assertThat(code).as(auvsim.err()).isZero();
        assertThat(report.resolve("predictions").resolve("three.csv")).isNotEmptyFile();
    }

    private static final String DRONE =
            BALL.replace("<gravity/>", "<gravity/><propulsor name=\"main\" maximum-thrust=\"1\"/>");

    private static final String SHAKING =
            "<column-mapping><shaking acceleration=\"ax\" rate=\"wy\"/></column-mapping>";

    /** The same fall, pushed ahead by 0.5 N, with two sensors that a rotor shakes. */
    private Path shaken(String name, long seed, double imbalance) throws IOException {
        Random lot = new Random(seed);
        StringBuilder text = new StringBuilder("t,x,y,z,main,ax,wy\n");
        for (int i = 0; i <= 60; i++) {
            double t = i / 30.0;
            double shaking = imbalance * lot.nextGaussian();
            text.append(
                    String.format(
                            Locale.ROOT,
                            "%.6f,%.5f,%.5f,%.5f,0.5,%.5f,%.5f%n",
                            t,
                            t * t / 2 + lot.nextGaussian(0, 0.005),
                            lot.nextGaussian(0, 0.005),
                            20 - GRAVITY * t * t / 2 + lot.nextGaussian(0, 0.005),
                            shaking + lot.nextGaussian(0, 0.3),
                            shaking + lot.nextGaussian(0, 0.3)));
        }
        return auvsim.file(name, text.toString());
    }

    @Test
    void whatShakesMoreThanReferenceRunsHasAPropellerOutOfBalance() throws IOException {
        Path report = folder.resolve("report");
        List<Object> arguments = new ArrayList<>(List.of("--fit", shaken("one.csv", 1, 3)));
        arguments.addAll(List.of("--holdout", shaken("two.csv", 2, 3), "--reference"));
        for (int i = 3; i < 9; i++) {
            arguments.add(shaken("sound" + i + ".csv", i, 1));
        }
        arguments.addAll(List.of("--mapping", auvsim.file("mapping.xml", SHAKING)));
        arguments.addAll(List.of("--causes", "buoyancy_weight", "--out", report));

        int code = diagnose(DRONE, arguments.toArray());

        assertThat(code).as(auvsim.err()).isZero();
        assertThat(auvsim.out())
                .contains(
                        "times as much as in the 6 reference runs, and moves as the model has it");
        assertThat(report.resolve("diagnosis.json"))
                .content()
                .contains("\"name\" : \"propeller_imbalance\"");
        assertThat(report.resolve("report.html")).content().contains("propeller_imbalance");
        assertThat(report.resolve("extended-scenario.xml")).content().contains("Nothing was added");
    }

    @Test
    void aReferenceThatIsNoneIsTold() throws IOException {
        Path run = shaken("run.csv", 1, 1);
        Path other = shaken("other.csv", 2, 1);
        Path mapping = auvsim.file("mapping.xml", SHAKING);
        Path report = folder.resolve("report");

        assertThat(diagnose(DRONE, "--fit", run, "--reference", run, "--mapping", mapping))
                .isEqualTo(2);
        assertThat(auvsim.err())
                .contains("is given as a reference and to be diagnosed; no run is its own measure");
        assertThat(
                        diagnose(
                                DRONE,
                                "--fit",
                                run,
                                "--reference",
                                other,
                                "--mapping",
                                mapping,
                                "--out",
                                report))
                .isEqualTo(2);
        assertThat(auvsim.err()).contains("--reference: there is 1 reference run; expected two");
    }

    @Test
    void optionsSayHowColumnsAreRead() throws IOException {
        Path run = auvsim.file("run.csv", "time,x,heading,volt\n0,1,2,3\n");

        int code =
                diagnose(
                        BALL,
                        "--fit",
                        run,
                        "--rename",
                        "time=t,heading=yaw",
                        "--ignore",
                        "volt",
                        "--ned",
                        "--degrees");

        assertThat(code).isEqualTo(2);
        assertThat(auvsim.err()).contains("run.csv:2: expected at least 16 rows, but found 1");
    }
}
