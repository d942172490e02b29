package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
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
    private static Process start(String manner) throws IOException {
        return new ProcessBuilder(
                        ENV.toString(),
                        "--default-signal=INT",
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        System.getProperty("java.class.path"),
                        Busy.class.getName(),
                        manner)
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
