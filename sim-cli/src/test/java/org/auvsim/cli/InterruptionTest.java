package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;

/** By a process of its own, which gets the signal that Ctrl-C sends. */
@EnabledOnOs(OS.LINUX)
@Timeout(120)
class InterruptionTest {
    private static final Path ENV = Path.of("/usr/bin/env");

    /** Goes on until it is interrupted; then it ends, or goes on for ever, or is given up. */
    static final class Busy {
        private Busy() {}

        public static void main(String[] arguments) throws InterruptedException {
            CountDownLatch asked = new CountDownLatch(1);
            Duration patience = Duration.ofMillis(arguments[0].equals("slow") ? 1 : 3_600_000);
            try (Interruption interruption =
                    new Interruption(
                            asked::countDown, patience, () -> System.out.println("given up"))) {
                System.out.println("busy");
                asked.await();
                System.out.println("asked to end: " + interruption.isRequested());
                if (!arguments[0].equals("obedient")) {
                    new CountDownLatch(1).await();
                }
                System.out.println("good end");
            }
            System.exit(0);
        }
    }

    /** Signals that whoever runs the tests ignores are as usual again. */
    private static ProcessBuilder java(String... arguments) {
        List<String> command = new ArrayList<>();
        command.add(ENV.toString());
        command.add("--default-signal=INT");
        command.addAll(OwnProcess.java());
        command.addAll(List.of(arguments));
        return new ProcessBuilder(command);
    }

    private static Process start(String manner) throws IOException {
        return java(Busy.class.getName(), manner)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
    }

    private static void interrupt(Process process) throws IOException, InterruptedException {
        new ProcessBuilder("kill", "-INT", String.valueOf(process.pid())).start().waitFor();
    }

    @Test
    void whatIsInterruptedComesToAGoodEnd() throws Exception {
        Process process = start("obedient");
        try (BufferedReader out = process.inputReader(UTF_8)) {
            assertThat(out.readLine()).isEqualTo("busy");
            interrupt(process);

            assertThat(out.lines()).containsExactly("asked to end: true", "good end");
            assertThat(process.waitFor()).isEqualTo(Interruption.EXIT_CODE);
        } finally {
            process.destroyForcibly();
        }
    }

    /** Runs in mm, which nothing explains, take long enough to be interrupted. */
    @Test
    void aDiagnosisThatIsInterruptedReportsTheBestSoFar(@TempDir Path folder) throws Exception {
        Path examples = Path.of("..", "examples", "diagnosis");
        Process process =
                java(
                                Auvsim.class.getName(),
                                "diagnose",
                                "--scenario",
                                examples.resolve("model.xml").toString(),
                                "--fit",
                                inMillimetres(examples.resolve("run1.csv"), folder),
                                inMillimetres(examples.resolve("run2.csv"), folder),
                                "--holdout",
                                inMillimetres(examples.resolve("run3.csv"), folder),
                                "--out",
                                folder.resolve("report").toString())
                        .redirectOutput(folder.resolve("out.txt").toFile())
                        .start();
        try (BufferedReader err = process.errorReader(UTF_8)) {
            String line = err.readLine();
            while (line != null && !line.contains(" %: ")) {
                line = err.readLine();
            }
            assertThat(line).as("progress").isNotNull();
            interrupt(process);

            assertThat(err.lines()).anyMatch(l -> l.startsWith("stopping: the best so far"));
            assertThat(process.waitFor()).isEqualTo(Interruption.EXIT_CODE);
        } finally {
            process.destroyForcibly();
        }
        assertThat(folder.resolve("out.txt"))
                .content()
                .matches("(?s)Stopped before (the end; the best so far|any cause was fitted): .*");
        assertThat(folder.resolve("report").resolve("diagnosis.json"))
                .content()
                .contains("\"complete\" : false");
    }

    private static String inMillimetres(Path run, Path folder) throws IOException {
        List<String> rows = new ArrayList<>();
        for (String row : Files.readAllLines(run)) {
            String[] cells = row.split(",", -1);
            for (int i = 1; i <= 3 && !rows.isEmpty(); i++) {
                cells[i] = String.valueOf(1000 * Double.parseDouble(cells[i]));
            }
            rows.add(String.join(",", cells));
        }
        return Files.write(folder.resolve(run.getFileName()), rows).toString();
    }

    @Test
    void whatTakesTooLongIsGivenUp() throws Exception {
        Process process = start("slow");
        try (BufferedReader out = process.inputReader(UTF_8)) {
            assertThat(out.readLine()).isEqualTo("busy");
            interrupt(process);

            assertThat(out.lines()).contains("given up").doesNotContain("good end");
            assertThat(process.waitFor()).isEqualTo(Interruption.EXIT_CODE);
        } finally {
            process.destroyForcibly();
        }
    }

    @Test
    void whatIsInterruptedAgainEndsAtOnce() throws Exception {
        Process process = start("stubborn");
        try (BufferedReader out = process.inputReader(UTF_8)) {
            assertThat(out.readLine()).isEqualTo("busy");
            interrupt(process);
            assertThat(out.readLine()).isEqualTo("asked to end: true");
            interrupt(process);

            assertThat(out.readLine()).isNull();
            assertThat(process.waitFor()).isEqualTo(Interruption.EXIT_CODE);
        } finally {
            process.destroyForcibly();
        }
    }
}
