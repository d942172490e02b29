package org.auvsim.diagnosis.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import org.auvsim.diagnosis.result.Alternative;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

class ReportTest {
    @TempDir private Path folder;

    private String page(Diagnosis diagnosis) throws IOException {
        return Files.readString(Report.write(diagnosis, folder));
    }

    private List<String> files() throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(Files::isRegularFile)
                    .map(file -> folder.relativize(file).toString().replace('\\', '/'))
                    .sorted()
                    .toList();
        }
    }

    @Test
    void hasAllItsFilesAndNoDrafts() throws IOException {
        Report.write(Diagnoses.explained(), folder);
        assertThat(files())
                .containsExactly(
                        "diagnosis.json",
                        "extended-scenario.xml",
                        "predictions/run3.csv",
                        "report.html",
                        "residuals/run1.csv",
                        "residuals/run2.csv",
                        "residuals/run3.csv");
    }

    @Test
    void replacesThoseOfAnEarlierReport() throws IOException {
        Files.createDirectories(folder.resolve("predictions"));
        Files.writeString(folder.resolve("predictions/old.csv"), "t\n");
        Files.writeString(folder.resolve("predictions/mine.txt"), "kept");
        Files.writeString(folder.resolve("diagnosis.json"), "{}");
        Report.write(Diagnoses.none(), folder);
        assertThat(files())
                .contains("predictions/mine.txt", "predictions/run3.csv")
                .doesNotContain("predictions/old.csv");
        assertThat(folder.resolve("diagnosis.json")).content().contains("\"none\"");
        assertThat(folder.resolve("report.html")).content().doesNotContain("Both models");
    }

    @Test
    void whatCannotBeWrittenIsLeftAsItWas() throws IOException {
        Path blocked = folder.resolve("report.html");
        Files.createDirectories(blocked.resolve("full"));
        assertThatIOException().isThrownBy(() -> Report.write(Diagnoses.none(), folder));
        assertThat(files()).doesNotContain("diagnosis.json").noneMatch(f -> f.endsWith(".part"));
    }

    @Test
    void runsThatWereToJudgeAreNotSaidToHaveDoneSo() throws IOException {
        assertThat(page(Diagnoses.searchedWithAll(Diagnoses.explained())))
                .contains("Measured and simulated: run3 (held out, but then searched with)")
                .doesNotContain("run3 (held out)");
    }

    @Test
    void ofCausesThatAreNotExaminedNothingIsPromised() throws IOException {
        assertThat(page(Diagnoses.explained()))
                .contains("Causes tied to a place, a moment or a frequency are not examined")
                .doesNotContain("where it shows best");
    }

    @Test
    void thePageBeginsWithTheVerdict() throws IOException {
        assertThat(page(Diagnoses.explained()))
                .containsSubsequence(
                        "<h1>sledge: explained</h1>",
                        "<p class=\"summary\">Quadratic drag is missing: 12.4 \u00b1 0.3 kg/m; it"
                                + " explains 99.1 % of the misfit; held-out position error 0.83 m"
                                + " \u2192 0.011 m, noise is 0.010 m.</p>",
                        "What was found",
                        "12.4 \u00b1 0.3 kg/m",
                        "Notices",
                        "20 samples a second",
                        "Gain on held-out runs",
                        "Measured and simulated: run3 (held out)",
                        "Causes that were tried",
                        "<p>Causes looked for: 62; sets of them that were fitted: 3.</p>",
                        ">magnus</td>",
                        ">s = 8.10 kg</td><td>minus infinity</td><td>&lt; 0.1 %</td>",
                        "What this data can tell apart",
                        "Unless they are very strong, these leave no trace in this data: magnus.",
                        "These change nothing that was measured",
                        ": restitution, contact_friction.",
                        "What could have been missed",
                        "<td>0.012</td>",
                        "What to measure next",
                        "coast with all thrusters off",
                        "The runs",
                        "In detail: run1 (fitted)",
                        "Residual of the orientation, as believed",
                        "Residual of the position over the velocity, as believed",
                        "Residual of the position over the position, with what was found",
                        "Residual of the orientation over the heading, as believed",
                        "Missing force, with what was found",
                        "Missing force over the velocity, as believed",
                        "Missing force over the heading, with what was found");
    }

    /** What is left of the missing force is as small as it looks. */
    @Test
    void forcesBeforeAndAfterAreOnOneScale() throws IOException {
        Matcher scales =
                Pattern.compile("\"title\":\"Missing force, [^\"]*\".*?" + "\"alsoUp\":(\\[[^]]+])")
                        .matcher(page(Diagnoses.explained()));

        List<String> found = scales.results().map(scale -> scale.group(1)).toList();

        assertThat(found).hasSize(6);
        for (int run = 0; run < found.size(); run += 2) {
            assertThat(found.get(run)).isEqualTo(found.get(run + 1)).isNotEqualTo("[]");
        }
    }

    @Test
    void thePageOfANullHasOneModel() throws IOException {
        assertThat(page(Diagnoses.none()))
                .contains("<h1>sledge: nothing missing</h1>")
                .contains("Residual of the position, simulated")
                .contains("<th>simulated</th><th>noise</th>")
                .doesNotContain("with what was found</h3>")
                .doesNotContain("<h2>Notices</h2>");
    }

    @Test
    void whereNothingIsLeftOpenThePageSaysSo() throws IOException {
        assertThat(page(Diagnoses.settled(Diagnoses.none())))
                .contains("<h2>What to measure next</h2>", "<p>No run is proposed: no other known")
                .doesNotContain("can imitate one");
    }

    @Test
    void severalCausesMayImitateOne() throws IOException {
        Finding one = Diagnoses.explained().selected().getFirst();
        Diagnosis three = Diagnoses.explained(List.of(one, one, one), 50, List.of());

        assertThat(page(Diagnoses.settled(three)))
                .contains("<p>No run is proposed: no other known", "can imitate one that is not");
    }

    @Test
    void whereNoRunTellsAlternativesApartThePageSaysSo() throws IOException {
        List<Alternative> drift = List.of(new Alternative(List.of("position_drift"), true, "", ""));
        assertThat(page(Diagnoses.settled(Diagnoses.explained(50, drift))))
                .contains("<p>No run is proposed: none of those considered would tell")
                .doesNotContain("no other known");
    }

    @Test
    void thePageSaysWhichOtherSensorWouldTell() throws IOException {
        Alternative scale =
                new Alternative(
                        List.of("sensor_scale"),
                        true,
                        "",
                        "velocity along x, by 0.30 m/s (root mean square)");
        assertThat(page(Diagnoses.settled(Diagnoses.explained(50, List.of(scale)))))
                .contains(
                        "Another sensor would tell sensor_scale apart in such runs: it differs in"
                                + " the velocity along x, by 0.30 m/s (root mean square).");
    }

    @Test
    void thePageOfASearchThatTriedNothingSaysNothingOfCauses() throws IOException {
        Diagnosis untried = Diagnoses.stopped(Diagnoses.untried(Diagnoses.unexplained()));
        assertThat(untried.isUntried()).isTrue();
        assertThat(page(untried))
                .contains("<h1>sledge: undecided, stopped early</h1>")
                .contains("Stopped before any cause was fitted: nothing can be said")
                .doesNotContain("<h2>Causes that were tried</h2>")
                .doesNotContain("No set of causes tried so far leaves");
    }

    @Test
    void thePageSaysWhyWhatHasMoreEvidenceWasNotChosen() throws IOException {
        assertThat(page(Diagnoses.explained())).doesNotContain("Not chosen");
        String reason = "it can imitate other causes";
        assertThat(page(Diagnoses.outweighed(Diagnoses.explained(), 3, reason)))
                .contains(
                        "Not chosen despite higher evidence: magnetic (it can imitate other"
                                + " causes).");
        assertThat(page(Diagnoses.outweighed(Diagnoses.explained(), 1e-3, reason)))
                .contains(
                        "Not chosen, though about as probable: magnetic (it can imitate other"
                                + " causes).");
    }

    @Test
    void thePageOfASearchThatWasStoppedSaysNoMore() throws IOException {
        assertThat(page(Diagnoses.stopped(Diagnoses.unexplained())))
                .contains("<h1>sledge: unexplained so far, stopped early</h1>")
                .contains("<p class=\"summary\">Stopped before the end; the best so far: ")
                .contains("No set of causes tried so far leaves")
                .contains(
                        "Causes to be looked for: 62; sets of them that were fitted before the"
                                + " search was stopped: 2, none of which explains the runs.")
                .doesNotContain("No set of known causes");
    }

    @Test
    void thePageOfTheUnexplainedSaysWhatIsKnown() throws IOException {
        assertThat(page(Diagnoses.unexplained()))
                .contains("<h1>sledge: unexplained</h1>")
                .contains(">the model is then at</td><td>x 3.21, y -0.500, z 2.00 m</td>")
                .contains(">frequency</td><td>0.31 Hz</td>")
                .contains("A proposal, not a named cause (formula): F.x = -1.2 v.x |v| &lt; 0.");
    }

    @Test
    void thePageTellsWhatCannotBeToldApart() throws IOException {
        Alternative other =
                new Alternative(List.of("thruster_gain"), true, "mass / thruster gain = 1.20", "");
        assertThat(page(Diagnoses.explained(200, List.of(other))))
                .contains("this data cannot tell apart: quadratic drag is missing, or the thrust")
                .contains(
                        ">thruster_gain</td><td class=\"words\">indistinguishable in such data</td>"
                                + "<td class=\"words\">mass / thruster gain = 1.20</td>");
    }

    @Test
    void numbersOfSeveralCausesStandUnderTheirNames() throws IOException {
        assertThat(page(Diagnoses.withPair(Diagnoses.explained())))
                .contains(">linear_drag: c = 8.10 N s/m; magnus: s = 0.200 kg</td>");
    }

    @Test
    void whereNoSetWasFittedThereIsNothingToRank() throws IOException {
        assertThat(page(Diagnoses.untried(Diagnoses.none())))
                .contains(
                        "<p>Causes looked for: 62; none of them promised enough to be"
                                + " fitted.</p>")
                .doesNotContain("<th>log evidence</th>");
    }

    /** Sets of more evidence than the one that errors are told of stand before it. */
    @Test
    void whereNothingExplainsThePageSaysWhatItsErrorsAreOf() throws IOException {
        String page = page(Diagnoses.overtaken(Diagnoses.unexplained(), "its gain is too small"));

        assertThat(page)
                .contains(
                        "Errors and residuals are those of the model as believed, despite higher"
                                + " evidence not with magnetic (its gain is too small).",
                        "less that of the set that has most.",
                        ", none of which explains the runs.")
                .doesNotContain("Not chosen", "which stands first");
    }

    @Test
    void aModelThatGetsLostHasNoErrorThere() throws IOException {
        assertThat(page(Diagnoses.lost(Diagnoses.explained())))
                .contains("Where a model gets lost it has no point.")
                .contains("\"x\":[5.0,60.0],\"y\":[0.08,null]");
        assertThat(page(Diagnoses.explained())).doesNotContain("gets lost");
    }

    /** How far ahead grows by factors, and so does the error of a model that is wrong. */
    @Test
    void errorsByHowFarAheadAreByPowersOfTen() throws IOException {
        assertThat(page(Diagnoses.explained()))
                .contains(
                        "\"title\":\"Error of the position by how far ahead is"
                                + " predicted\",\"x\":\"ahead (s)\",\"y\":\"error"
                                + " (m)\",\"axes\":\"logarithmic\"");
    }

    @Test
    void aModelThatBreaksOffLeavesMeasurementsAlone() throws IOException {
        assertThat(page(Diagnoses.brokenOff())).contains("<h3>Heading over time</h3>");
        assertThat(folder.resolve("predictions/run3.csv")).content().hasLineCount(1);
    }

    @Test
    void longRunsAreThinned() throws IOException {
        Path page = Report.write(Diagnoses.explained(20_001, List.of()), folder);
        assertThat(Files.size(page)).isLessThan(3_000_000);
        try (Stream<String> rows = Files.lines(folder.resolve("residuals/run1.csv"))) {
            assertThat(rows.count()).isEqualTo(20_002);
        }
    }
}
