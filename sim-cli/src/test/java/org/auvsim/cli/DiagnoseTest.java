package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
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
import java.util.stream.Collectors;
import java.util.stream.IntStream;

class DiagnoseTest {
    private static final double GRAVITY = 9.80665;

    private static final String BALL =
            """
            <scenario>
              <time-step delta="0.05"/>
              <world-object name="Ball" mass="0.5"><sphere radius="0.1"/><gravity/></world-object>
            </scenario>
            """;

    @TempDir private Path folder;
    private CommandLineHarness auvsim;

    @BeforeEach
    void begin() {
        auvsim = new CommandLineHarness(folder);
    }

    private int diagnose(String model, Object... options) throws IOException {
        List<Object> arguments = new ArrayList<>();
        arguments.addAll(List.of("diagnose", "--scenario", auvsim.file("model.xml", model)));
        arguments.addAll(List.of(options));
        return auvsim.run(arguments.toArray());
    }

    /** Two falls that are fitted and one that is held out, all swaying so far (m). */
    private int diagnoseFalls(String model, double sway, Object... options) throws IOException {
        List<Object> arguments = new ArrayList<>(List.of(options));
        arguments.addAll(List.of("--fit", fall("one.csv", 0, sway), fall("two.csv", 1, sway)));
        arguments.addAll(List.of("--holdout", fall("three.csv", 2, sway)));
        return diagnose(model, arguments.toArray());
    }

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
                .containsPattern("Causes looked for: [1-9][0-9]*; sets of them that were fitted: ")
                .contains("log evidence")
                .contains("none")
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

    /** After an option that takes many files. */
    @Test
    void anOptionThatIsMisspeltIsNoFile() throws IOException {
        int code = diagnose(BALL, "--fit", fall("one.csv", 0), "--holdot", fall("two.csv", 1));

        assertThat(code).isEqualTo(2);
        assertThat(auvsim.err())
                .startsWith("Unknown option: '--holdot'; did you mean '--holdout'?");
    }

    @Test
    void aMisspeltOptionIsToldWithItsValue() throws IOException {
        int code = diagnose(BALL, "--ft", fall("one.csv", 0), "--fit", fall("two.csv", 1));

        assertThat(code).isEqualTo(2);
        assertThat(auvsim.err()).startsWith("Unknown option: '--ft'; did you mean '--fit'?");
    }

    /** Though what it would have said is missing, too. */
    @Test
    void aMisspeltOptionIsToldBeforeTheMissingOne() throws IOException {
        int code = auvsim.run("diagnose", "--scenario", BALL, "--ft", fall("one.csv", 0));

        assertThat(code).isEqualTo(2);
        assertThat(auvsim.err()).startsWith("Unknown option: '--ft'; did you mean '--fit'?");
    }

    /** 2 s of a ball in vacuum that is thrown by lot, seen with 5 mm of noise. */
    private Path fall(String name, long seed) throws IOException {
        return fall(name, seed, 0);
    }

    /** The same, swaying once a second, so far (m) to each side. */
    private Path fall(String name, long seed, double sway) throws IOException {
        Random lot = new Random(seed);
        double vx = lot.nextDouble(-3, 3);
        double vy = lot.nextDouble(-3, 3);
        double vz = lot.nextDouble(0, 5);
        StringBuilder text = new StringBuilder("t,x,y,z\n");
        for (int i = 0; i <= 60; i++) {
            double t = i / 30.0;
            text.append(
                    String.format(
                            Locale.ROOT,
                            "%.6f,%.5f,%.5f,%.5f%n",
                            t,
                            vx * t + sway * Math.sin(2 * Math.PI * t) + lot.nextGaussian(0, 0.005),
                            vy * t + lot.nextGaussian(0, 0.005),
                            20 + vz * t - GRAVITY * t * t / 2 + lot.nextGaussian(0, 0.005)));
        }
        return auvsim.file(name, text.toString());
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
    void aMethodThatThereIsNotIsToldWithThoseThatThereAre() throws IOException {
        Path run = fall("run.csv", 0);

        assertThat(diagnose(BALL, "--fit", run, "--method", "guess")).isEqualTo(2);
        assertThat(auvsim.err())
                .contains("--method: expected shooting or genetic, but found 'guess'.");
    }

    @Test
    void aCauseThatIsUnknownIsToldWithWhereAllAre() throws IOException {
        Path run = fall("run.csv", 0);

        assertThat(
                        diagnose(
                                BALL,
                                "--fit",
                                run,
                                "--causes",
                                "linear_drag,rust",
                                "--out",
                                folder.resolve("report")))
                .isEqualTo(2);
        assertThat(auvsim.err())
                .isEqualTo(
                        "--causes: no cause 'rust' is known of 'Ball'; docs/causes.md has all, and"
                                + " what each of them needs\n");
    }

    /** Reading long runs takes its time. */
    @Test
    void aCauseThatIsUnknownIsToldBeforeRunsAreRead() throws IOException {
        assertThat(diagnose(BALL, "--fit", folder.resolve("none.csv"), "--causes", "rust"))
                .isEqualTo(2);
        assertThat(auvsim.err()).contains("'rust'").doesNotContain("none.csv");
    }

    @Test
    void aWrongCellIsNamedWithItsPlace() throws IOException {
        Path run = auvsim.file("run.csv", "t,x\n0,1\n0.1,far\n");

        assertThat(diagnose(BALL, "--fit", run)).isEqualTo(2);
        assertThat(auvsim.err())
                .contains("run.csv:3: column 'x': expected a number, but found 'far'");
    }

    @Test
    void theMeasuredBodyMustBeInTheScenario() throws IOException {
        Path run = fall("run.csv", 0);

        assertThat(diagnose(BALL, "--fit", run, "--body", "Box")).isEqualTo(2);
        assertThat(auvsim.err())
                .contains("model.xml: the scenario has no world object 'Box'; it has [Ball]");
    }

    @Test
    void ofSeveralBodiesOneMustBeChosen() throws IOException {
        String model =
                BALL.replace(
                        "</scenario>",
                        "<world-object name=\"Box\" mass=\"1\"><sphere radius=\"1\"/>"
                                + "<position x=\"9\" y=\"0\" z=\"0\"/></world-object>"
                                + "</scenario>");

        assertThat(diagnose(model, "--fit", fall("run.csv", 0))).isEqualTo(2);
        assertThat(auvsim.err())
                .contains(
                        "several objects can move (Ball, Box); say with --body which was measured");
    }

    @Test
    void ofVeryManyBodiesSomeAreTold() throws IOException {
        String balls =
                IntStream.rangeClosed(1, 8)
                        .mapToObj(
                                i ->
                                        """
                                        <world-object name="Ball %d" mass="1"><sphere radius="1"/>
                                          <position x="%d" y="0" z="0"/></world-object>
                                        """
                                                .formatted(i, 9 * i))
                        .collect(Collectors.joining());

        assertThat(diagnose("<scenario>" + balls + "</scenario>", "--fit", fall("run.csv", 0)))
                .isEqualTo(2);
        assertThat(auvsim.err()).contains("Ball 5, Ball 6 and 2 more); say with --body");
    }

    @Test
    void aFileIsNoFolderForAReport() throws IOException {
        Path taken = auvsim.file("taken", "");

        assertThat(
                        auvsim.run(
                                "diagnose",
                                "--scenario",
                                auvsim.file("model.xml", BALL),
                                "--fit",
                                fall("run.csv", 0),
                                "--out",
                                taken))
                .isEqualTo(2);
        assertThat(auvsim.err())
                .endsWith(
                        "Cannot write %s: something else of that name is there; give another name.\n"
                                .formatted(taken));
    }

    /** Who is root may write wherever there are files, so none is: what is no file system. */
    @Test
    @EnabledOnOs(OS.LINUX)
    void aFolderThatCannotBeWrittenIsToldBeforeRunsAreRead() throws IOException {
        Path run = auvsim.file("run.csv", "no run");

        assertThat(diagnose(BALL, "--fit", run, "--out", Path.of("/proc"))).isEqualTo(2);
        assertThat(auvsim.err())
                .isEqualTo(
                        "Cannot write /proc: no file can be made in /proc; give another folder"
                                + " (--out), or change the permissions of this one.\n");
    }

    @Test
    void whatEndsBeforeItsReportLeavesNoFolder() throws IOException {
        Path report = folder.resolve("report");

        assertThat(diagnoseFalls(BALL, 0, "--causes", "sensor_bias", "--out", report)).isEqualTo(2);
        assertThat(auvsim.err()).contains("can be looked for in these runs");
        assertThat(report).doesNotExist();
    }

    @Test
    void aRunInPlaceOfTheScenarioIsToldAsSuch() throws IOException {
        Path model = auvsim.file("model.xml", BALL);
        Path run = fall("run.csv", 0);

        assertThat(auvsim.run("diagnose", "--scenario", run, "--fit", model)).isEqualTo(2);
        assertThat(auvsim.run("diagnose", "--scenario", run, "--fit", run)).isEqualTo(2);
        assertThat(auvsim.err())
                .isEqualTo(
                        """
                        %1$s: expected a scenario, but this looks like CSV, and %2$s is a scenario: are they swapped? Give the scenario with --scenario, and the runs with --fit
                        %1$s: expected a scenario, but this looks like CSV; give the model with --scenario, and the measured runs with --fit
                        """
                                .formatted(run, model));
    }

    @Test
    void aScenarioWithoutAnythingThatMovesHasNoMeasuredBody() throws IOException {
        String model = BALL.replace("mass=\"0.5\"", "fixed=\"1\"");

        assertThat(diagnose(model, "--fit", fall("run.csv", 0))).isEqualTo(2);
        assertThat(auvsim.err()).contains("nothing in the scenario can move");
    }

    @Test
    void whatIsFittedCannotBeHeldOut() throws IOException {
        Path run = fall("run.csv", 0);

        assertThat(diagnose(BALL, "--fit", run, "--holdout", run)).isEqualTo(2);
        assertThat(auvsim.err()).contains("is given to fit and to hold out");
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

    @Test
    void aNewNameNeedsAnOldOne() throws IOException {
        assertThat(diagnose(BALL, "--fit", fall("run.csv", 0), "--rename", "x")).isEqualTo(2);
        assertThat(auvsim.err().lines())
                .first()
                .isEqualTo("--rename: expected NAME=USUAL, but found 'x'.");
    }

    @Test
    void runsThatAreMissingAreToldWithThoseThatMayBeMeant() throws IOException {
        Path run = fall("run.csv", 0);
        Path missing = Path.of("run.csv");
        Path other = folder.resolve("other.csv");

        assertThat(diagnose(BALL, "--fit", missing, "--holdout", other)).isEqualTo(2);
        assertThat(auvsim.err())
                .isEqualTo(
                        "run.csv: there is no such file; did you mean %s?\n%s: there is no such file\n"
                                .formatted(run, other));
    }

    @Test
    void aScenarioThatIsMissingIsToldWithOneThatMayBeMeant() throws IOException {
        Path model = auvsim.file("model.xml", BALL);
        Path missing = folder.resolve("model");

        assertThat(auvsim.run("diagnose", "--scenario", missing, "--fit", fall("run.csv", 0)))
                .isEqualTo(2);
        assertThat(auvsim.err())
                .isEqualTo(
                        "%s: there is no such file; did you mean %s?\n".formatted(missing, model));
    }

    @Test
    void aFolderIsNoRun() throws IOException {
        assertThat(diagnose(BALL, "--fit", folder)).isEqualTo(2);
        assertThat(auvsim.err()).contains(folder + " is a folder; expected a file, name one in it");
    }

    @Test
    void aMappingThatIsNoneIsTold() throws IOException {
        Path mapping = auvsim.file("mapping.xml", "<column-mapping><colum/></column-mapping>");

        assertThat(diagnose(BALL, "--fit", fall("run.csv", 0), "--mapping", mapping)).isEqualTo(2);
        assertThat(auvsim.err()).contains("mapping.xml:1:17: ").contains("colum");
    }
}
