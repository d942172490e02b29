package org.auvsim.checks.launcher;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;

@Timeout(60)
class PrerequisitesTest {
    private static final String NO_JDK =
            "auvsim: a JDK 25 is needed and none was found: install one (https://adoptium.net, or"
                    + " 'sdk install java 25-tem'), and if it is in an unusual place, set"
                    + " AUVSIM_JAVA_HOME to its folder.\n";

    @TempDir private Path folder;
    private Machine machine;

    @BeforeEach
    void install() throws Exception {
        folder = folder.toRealPath();
        machine = new Machine(folder);
    }

    @Test
    void withoutAJdkItSaysHowToGetOne() throws Exception {
        machine.maven("");
        assertThat(machine.run("demo")).isEqualTo(new Run(2, "", NO_JDK));
    }

    @ParameterizedTest
    @ValueSource(strings = {"17.0.15", "24", "26", "250"})
    void anotherVersionIsNone(String version) throws Exception {
        machine.maven("");
        machine.jdk(version, "usr/lib/jvm/other");
        assertThat(machine.run("demo")).isEqualTo(new Run(2, "", NO_JDK));
    }

    @Test
    void withoutMavenItSaysHowToGetIt() throws Exception {
        machine.jdk("25.0.1", "usr/lib/jvm/jdk-25");
        assertThat(machine.run("demo"))
                .isEqualTo(
                        new Run(
                                2,
                                "",
                                "auvsim: Maven 3.8 or newer is needed to build it and none was"
                                        + " found: install it ('apt install maven', 'brew install"
                                        + " maven', or https://maven.apache.org/install.html).\n"));
    }

    @Test
    void aBuiltOneNeedsNoMaven() throws Exception {
        machine.jdk("25.0.1", "usr/lib/jvm/jdk-25");
        machine.maven("");
        machine.run();
        Files.delete(folder.resolve("usr/bin/mvn"));
        assertThat(machine.run()).isEqualTo(new Run(0, folder + "\n", ""));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "usr/lib/jvm/temurin-25-jdk-amd64",
                "opt/jdk-25.0.1",
                "opt/java/openjdk",
                "Library/Java/JavaVirtualMachines/temurin-25.jdk/Contents/Home",
                "home/.sdkman/candidates/java/25-tem",
                "home/.jdks/with a blank"
            })
    void findsAJdkInAUsualPlaceAndGivesItToMaven(String place) throws Exception {
        machine.maven("");
        machine.jdk("17.0.15", "usr/lib/jvm/a-17");
        machine.jdk("25.0.1", place);
        assertThat(machine.run().code()).isZero();
        assertThat(machine.mavenCalls()).containsExactly(folder.resolve(place).toString());
    }

    @Test
    void findsTheJdkOnThePath() throws Exception {
        machine.maven("");
        Path jdk = machine.jdk("25.0.1", "elsewhere/jdk");
        Files.createSymbolicLink(folder.resolve("usr/bin/javac"), jdk.resolve("bin/javac"));
        assertThat(machine.run().code()).isZero();
        assertThat(Path.of(machine.mavenCalls().getFirst())).isEqualTo(jdk);
    }

    @Test
    void javaHomeComesFirstWhereItIsA25() throws Exception {
        machine.maven("");
        machine.jdk("25.0.1", "usr/lib/jvm/jdk-25");
        Path other = machine.jdk("17.0.15", "elsewhere/17");
        Path mine = machine.jdk("25.0.1", "elsewhere/mine");
        assertThat(start("JAVA_HOME", mine).code()).isZero();
        assertThat(start("JAVA_HOME", other).code()).isZero();
        assertThat(machine.mavenCalls())
                .containsExactly(mine.toString(), folder + "/usr/lib/jvm/jdk-25");
    }

    @Test
    void auvsimJavaHomeMustBeA25() throws Exception {
        machine.maven("");
        machine.jdk("25.0.1", "usr/lib/jvm/jdk-25");
        Path other = machine.jdk("17.0.15", "elsewhere/17");
        assertThat(start("AUVSIM_JAVA_HOME", other))
                .isEqualTo(
                        new Run(
                                2,
                                "",
                                "auvsim: AUVSIM_JAVA_HOME names "
                                        + other
                                        + ", which is not a JDK 25.\n"));
        assertThat(start("AUVSIM_JAVA_HOME", machine.jdk("25.0.1", "elsewhere/mine")).code())
                .isZero();
    }

    private Run start(String variable, Path value) throws Exception {
        return machine.start(Map.of(variable, value.toString()), machine.launcher()).end();
    }
}
