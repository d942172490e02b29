package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

import java.io.IOException;
import java.nio.file.Path;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** What {@code auvsim diagnose} cannot use, and how it says so. */
class DiagnoseRefusalsTest extends DiagnosedFalls {
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
    void aBodyThatIsTiedToAnotherOneIsNotMovedAlone() throws IOException {
        String towed =
                """
                <scenario>
                  <world-object name="Barge" mass="300"><sphere radius="0.5"/>
                    <tether to="7" length="4" stiffness="60"/></world-object>
                  <world-object id="7" name="Tug" mass="200"><sphere radius="0.4"/>
                    <position x="5" y="0" z="0"/></world-object>
                </scenario>
                """;

        assertThat(diagnose(towed, "--body", "Barge", "--fit", fall("run.csv", 0))).isEqualTo(2);
        assertThat(auvsim.err())
                .isEqualTo(
                        folder.resolve("model.xml")
                                + ": 'Barge' is tied to 'Tug', which moves, too; a diagnosis moves"
                                + " the measured body alone: fix 'Tug' (fixed=\"1\") if it hardly"
                                + " moves, or take the tie out and give what it does as a force of"
                                + " 'Barge', by columns or by a document beside each run\n");
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
