package org.auvsim.checks.launcher;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;

@Timeout(60)
class LauncherTest {
    private static final String FIRST_USE = "building auvsim (first use, about a minute) ...\n";
    private static final String SOURCES_CHANGED = "building auvsim (its sources changed) ...\n";

    @TempDir private Path folder;
    private Machine machine;

    @BeforeEach
    void install() throws Exception {
        folder = folder.toRealPath();
        machine = new Machine(folder);
        machine.jdk("25.0.1", "usr/lib/jvm/jdk-25");
        machine.maven("");
    }

    @Test
    void buildsOnFirstUseOnly() throws Exception {
        assertThat(machine.run("--help")).isEqualTo(new Run(0, folder + "\n--help\n", FIRST_USE));
        assertThat(machine.run("--help")).isEqualTo(new Run(0, folder + "\n--help\n", ""));
        assertThat(machine.mavenCalls()).containsExactly(folder + "/usr/lib/jvm/jdk-25");
    }

    @Test
    void passesArgumentsAndExitCodeOn() throws Exception {
        machine.run();
        assertThat(machine.run("fail", "two words", "*", "", "$HOME"))
                .isEqualTo(new Run(7, folder + "\nfail\ntwo words\n*\n\n$HOME\n", ""));
    }

    @Test
    void worksThroughSymbolicLinks() throws Exception {
        Path near = Files.createSymbolicLink(machine.home().resolve("near"), machine.launcher());
        Path relative =
                Files.createSymbolicLink(machine.home().resolve("a link"), near.getFileName());
        assertThat(machine.start(Map.of(), relative, "x").end())
                .isEqualTo(new Run(0, folder + "\nx\n", FIRST_USE));
    }

    @Test
    void rebuildsWhenASourceIsChangedAddedOrDeleted() throws Exception {
        machine.run();
        String added = "sim-cli/src/main/resources/added.txt";
        machine.source("sim-cli/src/main/java/Program.java", "class Program { int changed; }");
        assertThat(machine.run().err()).isEqualTo(SOURCES_CHANGED);
        machine.source(added, "");
        assertThat(machine.run().err()).isEqualTo(SOURCES_CHANGED);
        machine.source("pom.xml", "<project><version/></project>");
        assertThat(machine.run().err()).isEqualTo(SOURCES_CHANGED);
        Files.delete(machine.checkout().resolve("sim-cli/src/main/java/Program.java"));
        assertThat(machine.run().err()).isEqualTo(SOURCES_CHANGED);
        assertThat(machine.mavenCalls()).hasSize(5);
    }

    @Test
    void doesNotRebuildForATestOrForASwitchBack() throws Exception {
        machine.run();
        machine.source("sim-cli/src/test/java/ProgramTest.java", "class ProgramTest {}");
        assertThat(machine.run().err()).isEmpty();
        machine.source("pom.xml", "<project> </project>");
        machine.run();
        machine.source("pom.xml", "<project/>");
        assertThat(machine.run().err()).isEmpty();
        assertThat(machine.mavenCalls()).hasSize(2);
    }

    @Test
    void keepsAFewBuildsOnly() throws Exception {
        for (int i = 0; i < 5; i++) {
            machine.source("pom.xml", "<project>" + i + "</project>");
            machine.run();
        }
        try (var builds =
                Files.newDirectoryStream(machine.checkout().resolve("target/auvsim"), "[0-9]*")) {
            assertThat(builds).hasSize(3);
        }
    }

    @Test
    void twoFirstUsesAtOnceBuildOnce() throws Exception {
        Path gate = folder.resolve("gate");
        machine.maven("until [ -e '" + gate + "' ]; do sleep 0.1; done");
        Running first = machine.start(Map.of(), machine.launcher(), "first");
        assertThat(first.nextError() + "\n").isEqualTo(FIRST_USE);
        Running second = machine.start(Map.of(), machine.launcher(), "second");
        assertThat(second.nextError()).startsWith("waiting for another build of auvsim");
        Files.createFile(gate);
        assertThat(first.end()).isEqualTo(new Run(0, folder + "\nfirst\n", ""));
        assertThat(second.end()).isEqualTo(new Run(0, folder + "\nsecond\n", ""));
        assertThat(machine.mavenCalls()).hasSize(1);
    }

    @Test
    void takesOverTheLockOfABuildThatDied() throws Exception {
        Process dead = new ProcessBuilder("sh", "-c", "exit 0").start();
        dead.waitFor();
        machine.source("target/auvsim/lock/owner", dead.pid() + "\n");
        assertThat(machine.run()).isEqualTo(new Run(0, folder + "\n", FIRST_USE));
        assertThat(machine.checkout().resolve("target/auvsim/lock")).doesNotExist();
    }

    @Test
    void aFailedBuildNamesItsLogAndIsTriedAgain() throws Exception {
        machine.maven("echo 'no such symbol'; exit 1");
        Path log = machine.checkout().resolve("target/auvsim/build.log");
        Run failed =
                new Run(
                        2,
                        "",
                        FIRST_USE
                                + "auvsim: the build failed; what went wrong is in "
                                + log
                                + "\n");
        assertThat(machine.run()).isEqualTo(failed);
        assertThat(log).content().contains("no such symbol");
        assertThat(machine.run()).isEqualTo(failed);
        machine.maven("");
        assertThat(machine.run().code()).isZero();
    }
}
