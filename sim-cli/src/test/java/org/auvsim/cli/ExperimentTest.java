package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

@Timeout(120)
class ExperimentTest {
    @TempDir private Path folder;
    private CommandLineHarness auvsim;

    @BeforeEach
    void begin() {
        auvsim = new CommandLineHarness(folder);
    }

    private String page(String name) throws IOException {
        Path out = folder.resolve(name);
        assertThat(auvsim.run("experiment", name, "--quick", "--out", out)).isZero();
        Path page = out.resolve("report.html");
        assertThat(auvsim.out()).endsWith("The page: " + page.toAbsolutePath() + "\n");
        return Files.readString(page);
    }

    @Test
    void correctiveFeedbackLagsAsynchronouslyAndNotInLockstep() throws IOException {
        assertThat(page("cfs"))
                .contains("Corrective feedback (thesis, section 8.1)")
                .contains("In lock-step, which the thesis proposed, it is off by 0.00 m.")
                .contains(
                        "<td class=\"words\">C,"
                                + " lock-step</td><td>400</td><td>0.00</td><td>0.00</td>");
        assertThat(auvsim.err()).contains("A's growth over 100.0 s in steps of 0.001 s\n");
    }

    @Test
    void stagesAndRealTimeAreMeasuredForFiveSizes() throws IOException {
        assertThat(page("runtime"))
                .contains("Runtime of the thesis' algorithms (thesis, section 8.2)")
                .contains(">Figure 8.4: restricter, linear fit</td>")
                .contains("<td>0.999991</td>");
        assertThat(auvsim.err()).contains("\n50 spheres, one target").doesNotContain("60 spheres");
    }

    @Test
    void distributedRunsAreOneInLockstep() throws IOException {
        assertThat(page("distributed"))
                .contains("Distributed and non-distributed simulation (thesis, section 8.3)")
                .contains("This is a quick run, ")
                .contains("run 4: five clients, asynchronous", "run 5: five clients, lock-step")
                .containsOnlyOnce("<h3>Figure 8.8")
                .contains("In lock-step, 3 of 3 runs are that run bit for bit")
                .contains("One curve: the dashed ones lie upon the run inside the simulator.");
        assertThat(auvsim.err()).doesNotContain("INFO", "has come");
    }

    @Test
    void aFolderThatCannotBeIsExplained() throws IOException {
        Path file = auvsim.file("taken", "");
        assertThat(auvsim.run("experiment", "runtime", "--quick", "--out", file)).isEqualTo(2);
        assertThat(auvsim.err()).startsWith("Cannot write " + file);
    }

    @Test
    void anUnknownExperimentIsExplained() {
        assertThat(auvsim.run("experiment", "chapter9")).isEqualTo(2);
        assertThat(auvsim.err())
                .startsWith("NAME: expected cfs or runtime or distributed, but found 'chapter9'.");
    }
}
