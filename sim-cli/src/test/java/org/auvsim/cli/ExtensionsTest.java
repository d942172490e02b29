package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.auvsim.cli.ExtensionFolder.CHALK;
import static org.auvsim.cli.ExtensionFolder.EFFECT;
import static org.auvsim.cli.ExtensionFolder.PROCESSOR;
import static org.auvsim.cli.ExtensionFolder.PUSH;
import static org.auvsim.cli.ExtensionFolder.RENDERER;
import static org.auvsim.cli.ExtensionFolder.SHRUG;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** Users' jars in a folder: what they provide is there in every command. */
class ExtensionsTest {
    @TempDir private Path home;

    private ExtensionFolder folder = new ExtensionFolder(Path.of(""));
    private CommandLineHarness auvsim;
    private Path scenario = Path.of("");

    @BeforeEach
    void begin() throws IOException {
        auvsim = new CommandLineHarness(home);
        folder = new ExtensionFolder(Files.createDirectory(home.resolve("own")));
        scenario =
                auvsim.file(
                        "pushed.xml",
                        """
                        <scenario>
                          <time-step delta="0.1"/>
                          <feedback-processor override="Shrug"/>
                          <world-object id="1" name="cart" mass="2">
                            <sphere radius="1"/>
                            <own-push force="6"/>
                          </world-object>
                        </scenario>
                        """);
    }

    private void addBoth(ExtensionFolder to) throws IOException {
        to.add("push.jar", EFFECT, "own.OwnPush", PUSH);
        to.add("shrug.jar", PROCESSOR, "own.Shrug", SHRUG);
    }

    private String[] refusal(Object... arguments) {
        assertThat(auvsim.run(arguments)).isEqualTo(2);
        assertThat(auvsim.out()).isEmpty();
        return auvsim.err().split("\n", -1);
    }

    private void assertRefused(String... parts) {
        String[] lines = refusal("validate", scenario, "--extensions", folder.path());
        assertThat(lines).hasSize(2);
        assertThat(lines[0]).contains(parts).endsWith(".");
    }

    /** x = F t^2 / (2 m). */
    @Test
    void anEffectOfAJarMovesABodyOfAScenario() throws IOException {
        addBoth(folder);
        Path csv = home.resolve("run.csv");
        assertThat(
                        auvsim.run(
                                "run",
                                scenario,
                                "--until",
                                2,
                                "--out",
                                csv,
                                "--extensions",
                                folder.path()))
                .isZero();
        String last = Files.readAllLines(csv).getLast();
        assertThat(Double.parseDouble(last.split(",", -1)[2])).isCloseTo(6, within(1e-9));
    }

    @Test
    void theFolderMayBeNamedBeforeTheCommand() throws IOException {
        addBoth(folder);
        assertThat(auvsim.run("--extensions", folder.path(), "validate", scenario)).isZero();
        assertThat(auvsim.out()).endsWith("pushed.xml: ok\n");
    }

    @Test
    void theUsersFolderNeedsNoOption() throws IOException {
        addBoth(
                new ExtensionFolder(
                        Files.createDirectories(home.resolve(".auvsim").resolve("extensions"))));
        assertThat(auvsim.run("validate", scenario)).isZero();
    }

    @Test
    void withoutItsJarTheEffectIsUnknown() {
        assertThat(auvsim.run("validate", scenario)).isEqualTo(2);
        assertThat(auvsim.out()).contains("own-push");
    }

    @Test
    @Timeout(60)
    void aServerHasTheProcessorOfAJar() throws Exception {
        addBoth(folder);
        try (ServerProcess server =
                new ServerProcess(scenario, "--extensions", folder.path().toString())) {
            assertThat(server.port()).isPositive();
        }
    }

    @Test
    void theContextIsAsBeforeAfterwards() throws IOException {
        addBoth(folder);
        ClassLoader before = Thread.currentThread().getContextClassLoader();
        auvsim.run("validate", scenario, "--extensions", folder.path());
        assertThat(Thread.currentThread().getContextClassLoader()).isSameAs(before);
    }

    @Test
    void helpTellsTheOptionWhateverIsInTheFolder() throws IOException {
        Files.writeString(folder.path().resolve("broken.jar"), "no jar");
        assertThat(auvsim.run("--extensions", folder.path(), "--help")).isZero();
        assertThat(auvsim.out().replaceAll("\\s+", ""))
                .contains("--extensions=DIR", "~/.auvsim/extensions");
        assertThat(auvsim.run("run", "--help")).isZero();
    }

    @Test
    void aFolderThatIsNotThereIsNamed() {
        Path missing = home.resolve("missing");
        assertThat(refusal("validate", scenario, "--extensions", missing))
                .containsExactly(
                        "--extensions: there is no folder %s; name a folder with jars of extensions."
                                .formatted(missing),
                        "");
    }

    @Test
    void aFileIsNoFolder() {
        assertThat(refusal("--extensions", scenario, "validate", scenario)[0])
                .isEqualTo(
                        "--extensions: %s is no folder; name a folder with jars of extensions."
                                .formatted(scenario));
    }

    @Test
    void aDamagedJarIsNamed() throws IOException {
        Files.writeString(folder.path().resolve("broken.jar"), "no jar");
        assertRefused("broken.jar is no jar, or a damaged one", "build it again");
    }

    @Test
    void aClassThatIsNotThereIsNamed() throws IOException {
        folder.add("push.jar", EFFECT, "own.OwnPush", PUSH);
        folder.pack("lost.jar", EFFECT, "own.Lost", Files.createDirectory(home.resolve("none")));
        assertRefused("lost.jar names own.Lost for " + EFFECT, "is in no jar");
    }

    @Test
    void aClassThatIsNoEffectIsNamed() throws IOException {
        folder.add("shrug.jar", EFFECT, "own.Shrug", SHRUG);
        assertRefused("shrug.jar names own.Shrug", "does not implement it");
    }

    @Test
    void anEffectThatIsNoRecordIsNamed() throws IOException {
        String source = PUSH.replace("record OwnPush(double force)", "class OwnPush");
        folder.add("push.jar", EFFECT, "own.OwnPush", source.replace("(force,", "(1,"));
        assertRefused("push.jar names own.OwnPush", "is no record");
    }

    @Test
    void aProcessorThatCannotBeMadeIsNamed() throws IOException {
        String source = SHRUG.replaceFirst("@Override", "public Shrug(int n) {} @Override");
        folder.add("shrug.jar", PROCESSOR, "own.Shrug", source);
        assertRefused("shrug.jar names own.Shrug", "public constructor without parameters");
    }

    @Test
    void anInterfaceThatIsNotThereIsNamed() throws IOException {
        folder.add("push.jar", "org.auvsim.core.Efect", "own.OwnPush", PUSH);
        assertRefused("push.jar has a provider file for org.auvsim.core.Efect");
    }

    @Test
    void aClassOfANewerJavaIsNamed() throws IOException {
        Path classes = Files.createDirectory(home.resolve("newer"));
        ExtensionFolder.compile("own.OwnPush", PUSH, classes);
        Path file = classes.resolve("own/OwnPush.class");
        byte[] bytes = Files.readAllBytes(file);
        bytes[7]++;
        Files.write(file, bytes);
        folder.pack("newer.jar", EFFECT, "own.OwnPush", classes);
        assertRefused("newer.jar names own.OwnPush", "newer Java", "--release");
    }

    @Test
    void aClassWithoutALibraryThatItNeedsIsNamed() throws IOException {
        Path classes = Files.createDirectory(home.resolve("parts"));
        ExtensionFolder.compile(
                "own.OwnPush",
                PUSH.replace("}\n}\n", "}\n    public Part part() { return null; }\n}\n")
                        + "record Part() {}\n",
                classes);
        Files.delete(classes.resolve("own/Part.class"));
        folder.pack("part.jar", EFFECT, "own.OwnPush", classes);
        assertRefused("part.jar names own.OwnPush", "needs a class that is in no jar (own/Part)");
    }

    @Test
    void twoJarsWithOneNameAreNamed() throws IOException {
        folder.add("push.jar", EFFECT, "own.OwnPush", PUSH);
        folder.add(
                "push2.jar", EFFECT, "other.OwnPush", PUSH.replace("package own", "package other"));
        assertRefused("push.jar and ", "push2.jar both provide the Effect 'own-push'");
    }

    @Test
    void theSameJarTwiceIsNamed() throws IOException {
        for (String name : List.of("a.jar", "b.jar")) {
            folder.add(name, PROCESSOR, "own.Shrug", SHRUG);
        }
        assertRefused("a.jar and ", "b.jar both provide the FeedbackProcessor 'Shrug'");
    }

    @Test
    void twoRenderersWithOneNameAreNamed() throws IOException {
        folder.add("a.jar", RENDERER, "own.Chalk", CHALK);
        folder.add("b.jar", RENDERER, "own.Pen", CHALK.replace("Chalk", "Pen"));
        assertRefused("a.jar and ", "b.jar both provide the Renderer 'chalk'");
    }

    @Test
    void aRendererWithTheNameOfAuvsimsOwnIsNamed() throws IOException {
        folder.add("a.jar", RENDERER, "own.Chalk", CHALK.replace("\"chalk\"", "\"jme\""));
        assertRefused("a.jar provides the Renderer 'jme', as auvsim itself does");
    }

    @Test
    void aNameOfAuvsimsOwnIsNamed() throws IOException {
        folder.add("gravity.jar", EFFECT, "own.Gravity", PUSH.replace("OwnPush", "Gravity"));
        assertRefused("gravity.jar provides the Effect 'gravity', as auvsim itself does");
    }
}
