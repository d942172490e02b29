package org.auvsim.experiments.scoreboard;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.diagnosis.Method;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.experiments.hidden.CaseKind;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

class ScoreFilesTest {
    private static final Plan PLAN =
            new Plan(7, 3, List.of(CaseKind.SINGLE), List.of(0.01, 0.05), 0);

    @TempDir private Path folder;

    private static Outcome outcome(double noise, long seed) {
        return outcome(Method.SHOOTING, noise, seed);
    }

    private static Outcome outcome(Method method, double noise, long seed) {
        return new Outcome(
                method,
                CaseKind.SINGLE,
                noise,
                seed,
                "ball",
                List.of("linear_drag"),
                new Answer(Verdict.EXPLAINED, List.of("linear_drag")),
                true,
                true,
                List.of(0.0025),
                List.of(0.002),
                1,
                1,
                0.004,
                new AliasTold(false, false),
                List.of(),
                false,
                1,
                "");
    }

    private static List<Outcome> some(int count) {
        return PLAN.drawings().subList(0, count).stream()
                .map(drawing -> outcome(drawing.noise(), drawing.seed()))
                .toList();
    }

    @Test
    void whatWasNotJudgedIsTold() throws IOException {
        ScoreFiles.write(folder, PLAN, some(3));

        assertThat(Files.readString(folder.resolve("scores.json"), UTF_8).replaceAll("\\s+", ""))
                .contains("\"complete\":false,\"diagnoses\":6,\"judged\":3")
                .contains("\"noise\":0.01,\"method\":\"shooting\",\"judged\":2")
                .contains("\"error_left\":{\"value\":0.004,\"unit\":\"1\"}")
                .contains("\"noise\":0.05,\"method\":\"shooting\",\"judged\":1");
        assertThat(folder.resolve("report.html"))
                .content()
                .contains("Incomplete: 3 of 6 diagnoses were judged. 3 of 3 cases are right.");
        assertThat(PLAN.shortfall(3)).contains("Incomplete: 3 of 6 diagnoses were judged.");
    }

    /** The first case is searched by both, the second by one. */
    @Test
    void modelsThatCompeteStandBesideTheMainMethod() throws IOException {
        Plan plan = new Plan(7, 2, List.of(CaseKind.SINGLE), List.of(0.01), 1);
        List<Outcome> outcomes =
                plan.drawings().stream()
                        .map(each -> outcome(each.method(), each.noise(), each.seed()))
                        .toList();

        ScoreFiles.write(folder, plan, outcomes);

        assertThat(plan.drawings())
                .extracting(Plan.Drawing::method)
                .containsExactly(Method.SHOOTING, Method.GENETIC, Method.SHOOTING);
        assertThat(Files.readAllLines(folder.resolve("cases.csv"), UTF_8))
                .hasSize(4)
                .anyMatch(line -> line.startsWith("genetic,single,0.01,7,"));
        assertThat(Files.readString(folder.resolve("scores.json"), UTF_8).replaceAll("\\s+", ""))
                .contains("\"noise\":0.01,\"method\":\"genetic\",\"judged\":1")
                .contains("\"noise\":0.01,\"method\":\"shooting\",\"judged\":2");
        assertThat(folder.resolve("report.html"))
                .content()
                .contains("the first 1 also by models that compete (genetic).")
                .contains("noise 1.0 %, genetic");
    }

    @Test
    void whatIsCompleteIsNotCalledOtherwise() throws IOException {
        ScoreFiles.write(folder, PLAN, some(6));

        assertThat(folder.resolve("scores.json")).content().contains("\"complete\" : true");
        assertThat(folder.resolve("report.html")).content().doesNotContain("Incomplete");
        assertThat(PLAN.shortfall(6)).isEmpty();
    }

    /** The target of one is in per cent, that of the other a share. */
    @Test
    void figuresHaveTheUnitsOfTheirTargets() {
        Scores scores = Scores.of(0.01, Method.SHOOTING, some(1));

        assertThat(Figure.PARAMETER_ERROR.of(scores)).isEqualTo("0.250 %");
        assertThat(Figure.PARAMETER_ERROR.target()).endsWith("%");
        assertThat(Figure.ERROR_LEFT.of(scores)).isEqualTo("0.00400");
        assertThat(Figure.ERROR_LEFT.target()).doesNotContain("%");
    }
}
