package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

import javax.imageio.ImageIO;

class BenchTest {
    @TempDir private Path folder;
    private CommandLineHarness auvsim;

    @BeforeEach
    void begin() {
        auvsim = new CommandLineHarness(folder);
    }

    @ParameterizedTest
    @ValueSource(strings = {"event", "snapshot"})
    void aRowIsMeasuredForEachNumberOfBodies(String stepper) throws IOException {
        Path out = folder.resolve("deep").resolve("bench");

        assertThat(
                        auvsim.run(
                                "bench",
                                "--quick",
                                "--bodies",
                                "2,8",
                                "--stepper",
                                stepper,
                                "--out",
                                out))
                .isZero();

        assertThat(auvsim.out().lines())
                .hasSize(5)
                .anyMatch(line -> line.startsWith("       2 "))
                .anyMatch(line -> line.startsWith("       8 "))
                .last()
                .isEqualTo("2 rows written to " + out.resolve("bench.csv"));
        List<String> csv = Files.readAllLines(out.resolve("bench.csv"), UTF_8);
        assertThat(csv).hasSize(3);
        assertThat(csv.getFirst())
                .isEqualTo(
                        "bodies,seed,restitution,world_s,repetitions,best_s,median_s,"
                                + "times_real_time,collisions,events,body_steps_per_s,"
                                + "ns_per_body_step,peak_memory_bytes,energy_drift_percent,"
                                + "largest_overlap_radii");
        List<String> eight = List.of(csv.get(2).split(","));
        assertThat(eight).startsWith("8", "1", "1.0", "5.0", "1").hasSize(15);
        assertThat(Double.parseDouble(eight.get(7))).isPositive();
        // Eight bodies of 10 N meet within 5 s.
        assertThat(Long.parseLong(eight.get(8))).isPositive();
        assertThat(image(out.resolve("bench.png")).getHeight()).isGreaterThan(600);
    }

    @Test
    void theStagesAreCountedAndFitted() throws IOException {
        assertThat(
                        auvsim.run(
                                "bench",
                                "--thesis",
                                "--bodies",
                                "2,4,6,8,10",
                                "--seconds",
                                0.5,
                                "--out",
                                folder))
                .isZero();

        assertThat(auvsim.out())
                .contains("Figure 8.4: restricter, linear fit")
                .contains("in the thesis 0.999567")
                .contains("Figure 8.7: wall time, cubic fit");
        List<String> csv = Files.readAllLines(folder.resolve("thesis.csv"), UTF_8);
        assertThat(csv).hasSize(6).first().isEqualTo("bodies,restricter,octree,finder,wall_s");
        assertThat(image(folder.resolve("thesis.png")).getWidth()).isEqualTo(900);
    }

    private static BufferedImage image(Path file) throws IOException {
        BufferedImage image = ImageIO.read(file.toFile());
        assertThat(image).as("a picture in " + file).isNotNull();
        return image;
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--bodies | 10,0 | --bodies must be 1 or more, but one is 0.",
                "--repeat | 0 | --repeat must be 1 or more, but is 0.",
                "--restitution | 1.5 | --restitution must be 0 to 1, but is 1.5.",
                "--seconds | 0 | --seconds must be above 0 s and finite, but is 0.0 s.",
                "--bodies | 10,ten | --bodies: expected a whole number, but found 'ten'.",
                "--repeat | 1.5 | --repeat: expected a whole number, but found '1.5'.",
                "--seconds | long | --seconds: expected a number, but found 'long'.",
                "--stepper | octree | --stepper: expected event or snapshot, but found 'octree'.",
            })
    void whatMeansNothingIsExplained(String option, String value, String sentence) {
        assertThat(auvsim.run("bench", option, value, "--out", folder)).isEqualTo(2);
        assertThat(auvsim.err().lines()).first().isEqualTo(sentence);
        assertThat(auvsim.out()).isEmpty();
    }

    @Test
    void whatIsStatedCountsBeforeWhatIsQuick() throws IOException {
        assertThat(
                        auvsim.run(
                                "bench",
                                "--quick",
                                "--bodies",
                                3,
                                "--seconds",
                                0.5,
                                "--repeat",
                                2,
                                "--out",
                                folder))
                .isZero();

        Path csv = folder.resolve("bench.csv");
        assertThat(auvsim.out().lines()).last().isEqualTo("1 row written to " + csv);
        assertThat(Files.readAllLines(csv, UTF_8)).last().asString().startsWith("3,1,1.0,0.5,2,");
    }

    @Test
    void aFolderThatCannotBeIsExplained() throws IOException {
        Path file = auvsim.file("taken", "a file");

        assertThat(auvsim.run("bench", "--quick", "--bodies", 1, "--out", file)).isEqualTo(2);
        assertThat(auvsim.err()).startsWith("Cannot write " + file + ": ").hasLineCount(1);
    }
}
