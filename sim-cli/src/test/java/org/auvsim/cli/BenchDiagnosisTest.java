package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

class BenchDiagnosisTest {
    @TempDir private Path folder;
    private CommandLineHarness auvsim;

    @BeforeEach
    void begin() {
        auvsim = new CommandLineHarness(folder);
    }

    @Test
    void aCaseIsJudgedAndAllFiguresAreWritten() throws IOException {
        Path out = folder.resolve("score");

        assertThat(
                        auvsim.run(
                                "bench",
                                "diagnosis",
                                "--kind",
                                "null",
                                "--noise",
                                "0.01",
                                "--seed",
                                1,
                                "--cases",
                                1,
                                "--out",
                                out))
                .isZero();

        assertThat(auvsim.out().lines())
                .anyMatch(line -> line.matches("(right|WRONG) null .* seed 1 .* said: .*"))
                .anyMatch(line -> line.matches("false alarms .*of 1.*"))
                .last()
                .isEqualTo("1 row written to " + out.resolve("cases.csv"));
        assertThat(Files.readAllLines(out.resolve("cases.csv"), UTF_8))
                .hasSize(2)
                .last()
                .asString()
                .startsWith("shooting,null,0.01,1,")
                .endsWith("auvsim bench diagnosis --kind null --noise 0.01 --seed 1 --cases 1");
        assertThat(out.resolve("scores.json")).content().contains("\"false_alarms\" : {");
        assertThat(out.resolve("report.html")).content().contains("sparse regression: named");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--cases | 0 | --cases must be 1 or more, but is 0.",
                "--genetic | -1 | --genetic must be 0 or more, but is -1.",
                "--noise | 2 | --noise must be above 0 and below 1, but is 2.0.",
                "--seed | last | --seed: expected a whole number, but found 'last'.",
                "--kind | five | --kind: expected single or pair or null or uncovered or weak or"
                        + " alias, but found 'five'.",
            })
    void whatMeansNothingIsExplained(String option, String value, String sentence) {
        assertThat(auvsim.run("bench", "diagnosis", option, value, "--out", folder)).isEqualTo(2);
        assertThat(auvsim.err().lines()).first().isEqualTo(sentence);
    }
}
