package org.auvsim.checks.launcher;

import org.auvsim.checks.Repository;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * A machine with nothing on it but a clone of a small project, the launcher in it, and the standard
 * tools. A JDK or a Maven installed on it is a stand-in: this JDK's java prints its folder and the
 * program's arguments, this Maven notes that it was called and leaves a jar.
 */
final class Machine {
    private static final String TOOLS =
            "basename cat cksum cp dirname find grep ls mkdir readlink rm rmdir sh sleep sort tail"
                    + " touch tr";
    private static final String JAVA =
            """
            #!/bin/sh
            case $1 in -XX:AOTCacheOutput=*) exit ;; esac
            while [ "$1" != -jar ]; do shift; done
            shift 2
            pwd
            for argument; do printf '%s\n' "$argument"; done
            [ "${1:-}" != fail ] || exit 7
            """;

    private final Path folder;
    private final Path tools;
    private final Map<String, String> environment;

    /** In a folder whose path has no blanks; that of the clone in it has. */
    Machine(Path folder) throws IOException {
        this.folder = folder;
        tools = Files.createDirectories(folder.resolve("usr/bin"));
        Files.createDirectories(home());
        environment = Map.of("PATH", tools.toString(), "HOME", home().toString());
        for (String tool : TOOLS.split(" ", -1)) {
            script(tools.resolve(tool), "#!/bin/sh\nexec " + real(tool) + " \"$@\"\n");
        }
        source("pom.xml", "<project/>");
        source("sim-cli/pom.xml", "<project/>");
        source("sim-cli/src/main/java/Program.java", "class Program {}");
        script(launcher(), onThisMachine(Files.readString(Repository.root().resolve("auvsim"))));
    }

    private static Path real(String tool) {
        return Stream.of("/usr/bin", "/bin")
                .map(bin -> Path.of(bin, tool))
                .filter(Files::exists)
                .findFirst()
                .orElseThrow();
    }

    /** The launcher looks in the folders of this machine, not of the one that runs the tests. */
    private String onThisMachine(String launcher) {
        return launcher.replaceAll(" /(usr|opt|Library)/", " " + folder + "/$1/");
    }

    Path checkout() {
        return folder.resolve("a clone");
    }

    Path launcher() {
        return checkout().resolve("auvsim");
    }

    Path home() {
        return folder.resolve("home");
    }

    /** Writes a file of the project. */
    void source(String name, String text) throws IOException {
        Path file = checkout().resolve(name);
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
    }

    /** Installs a JDK at a place of this machine. */
    Path jdk(String version, String place) throws IOException {
        Path jdk = folder.resolve(place);
        Files.createDirectories(jdk.resolve("bin"));
        Files.writeString(jdk.resolve("release"), "JAVA_VERSION=\"" + version + "\"\n");
        script(jdk.resolve("bin/java"), JAVA);
        script(jdk.resolve("bin/javac"), JAVA);
        return jdk;
    }

    /** Installs Maven; {@code before} is what its build does before it succeeds. */
    void maven(String before) throws IOException {
        script(
                tools.resolve("mvn"),
                """
                #!/bin/sh
                echo "$JAVA_HOME" >>'%s/mvn-calls'
                %s
                mkdir -p sim-cli/target/launcher/lib
                touch sim-cli/target/launcher/auvsim.jar
                """
                        .formatted(folder, before));
    }

    /** The JAVA_HOME of every call of Maven. */
    List<String> mavenCalls() throws IOException {
        Path calls = folder.resolve("mvn-calls");
        return Files.exists(calls) ? Files.readAllLines(calls) : List.of();
    }

    /** Runs the launcher to its end. */
    Run run(String... arguments) throws IOException, InterruptedException {
        return start(Map.of(), launcher(), arguments).end();
    }

    /** Starts the launcher by a path of its, in the machine's root folder. */
    Running start(Map<String, String> more, Path launcher, String... arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of(launcher.toString()));
        command.addAll(List.of(arguments));
        var builder = new ProcessBuilder(command).directory(folder.toFile());
        builder.environment().clear();
        builder.environment().putAll(environment);
        builder.environment().putAll(more);
        return new Running(builder.start());
    }

    private static void script(Path file, String text) throws IOException {
        Files.writeString(file, text);
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
    }
}
