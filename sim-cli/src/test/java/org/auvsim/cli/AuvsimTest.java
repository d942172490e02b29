package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.cli.report.UserError;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import picocli.CommandLine;
import picocli.CommandLine.Command;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;

class AuvsimTest {
    @TempDir private Path reports;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    @Test
    void helpListsTheCommands() {
        assertThat(run("--help")).isZero();
        assertThat(out.toString()).contains("Usage: auvsim").contains("generate-completion");
        assertThat(err.toString()).isEmpty();
    }

    @Test
    void versionIsThatOfTheBuild() {
        assertThat(run("--version")).isZero();
        assertThat(out.toString()).matches("auvsim \\d+\\.\\d+\\.\\d+\\R");
    }

    @Test
    void completionIsAShellScript() {
        assertThat(run("generate-completion")).isZero();
        assertThat(out.toString()).startsWith("#!").contains("complete -F _complete_auvsim");
    }

    @Test
    void anUnknownCommandIsExplained() {
        assertThat(run("zzz")).isEqualTo(2);
        assertThat(err.toString())
                .isEqualToNormalizingNewlines(
                        "Unmatched argument at index 0: 'zzz'\nTry 'auvsim --help'.\n");
    }

    @Test
    void noCommandIsExplained() {
        assertThat(run()).isEqualTo(2);
        assertThat(err.toString())
                .isEqualToNormalizingNewlines("Say which command to run.\nTry 'auvsim --help'.\n");
    }

    @Test
    void anOptionOfASubcommandIsExplainedByThatSubcommand() {
        assertThat(run("act", "--fins")).isEqualTo(2);
        assertThat(err.toString()).contains("'--fins'").contains("Try 'auvsim act --help'.");
    }

    @Test
    void aUserErrorIsOneSentence() {
        int code =
                run(
                        () -> {
                            throw new UserError("tank.xml is not there: name a scenario.");
                        },
                        "act");
        assertThat(code).isEqualTo(2);
        assertThat(err.toString())
                .isEqualToNormalizingNewlines("tank.xml is not there: name a scenario.\n");
        assertThat(reports).isEmptyDirectory();
    }

    @Test
    void aFaultOfOurOwnIsOneSentenceAndAReport() throws IOException {
        int code =
                run(
                        () -> {
                            throw new IllegalStateException("the world is flat");
                        },
                        "act");
        assertThat(code).isEqualTo(70);
        List<Path> files;
        try (var found = Files.list(reports)) {
            files = found.toList();
        }
        assertThat(files).hasSize(1);
        assertThat(err.toString())
                .isEqualToNormalizingNewlines(
                        "auvsim failed by a fault of its own; please report "
                                + files.getFirst()
                                + "\n");
        assertThat(Files.readString(files.getFirst(), UTF_8))
                .contains("IllegalStateException: the world is flat")
                .contains("at org.auvsim.cli.AuvsimTest");
    }

    private int run(String... arguments) {
        return run(() -> 0, arguments);
    }

    private int run(Callable<Integer> action, String... arguments) {
        CommandLine line = Auvsim.commandLine(reports, reports).addSubcommand(new Act(action));
        return line.setOut(new PrintWriter(out)).setErr(new PrintWriter(err)).execute(arguments);
    }

    @Command(name = "act")
    private record Act(Callable<Integer> action) implements Callable<Integer> {
        @Override
        public Integer call() throws Exception {
            return action.call();
        }
    }
}
