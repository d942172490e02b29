package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** What the documentation shows of scenarios, a reader may copy: a world is built of it. */
class DocumentedExamplesTest {
    private static final Path DOCS = Path.of("..", "docs");
    private static final Pattern BLOCK =
            Pattern.compile("^ *```xml\\n(.*?)^ *```$", Pattern.DOTALL | Pattern.MULTILINE);

    @TempDir private Path folder;

    /** What stands between fences, and where. */
    record Example(String file, int line, String text) {
        boolean isOfScenario() {
            return !text.startsWith("<auvsml>") && !text.startsWith("<project");
        }

        @Override
        public String toString() {
            return file + ":" + line;
        }
    }

    static Stream<Example> examples() throws IOException {
        try (Stream<Path> files = Files.list(DOCS)) {
            List<Path> documents =
                    files.filter(file -> file.toString().endsWith(".md")).sorted().toList();
            List<Example> examples = new ArrayList<>();
            for (Path document : documents) {
                examples.addAll(examplesOf(document));
            }
            return examples.stream().filter(Example::isOfScenario);
        }
    }

    private static List<Example> examplesOf(Path document) throws IOException {
        String text = Files.readString(document, UTF_8);
        return BLOCK.matcher(text)
                .results()
                .map(
                        found ->
                                new Example(
                                        document.getFileName().toString(),
                                        1 + (int) text.substring(0, found.start()).lines().count(),
                                        found.group(1).strip()))
                .toList();
    }

    @ParameterizedTest
    @MethodSource("examples")
    void isAccepted(Example example) throws Exception {
        CommandLineHarness auvsim = new CommandLineHarness(folder);
        Path file = auvsim.file("example.xml", scenario(example.text()));

        assertThat(auvsim.run("validate", file)).as(auvsim.err()).isZero();
    }

    /** A part of a body is given one, with the propulsor that a schedule is for. */
    private static String scenario(String text) {
        if (text.startsWith("<scenario>")) {
            return text;
        }
        String body =
                text.startsWith("<world-object")
                        ? text
                        : """
                        <world-object name="Body" mass="1"><sphere radius="1"/>
                          <propulsor name="Aft Thruster" maximum-thrust="1"/>
                          %s
                        </world-object>
                        """
                                .formatted(text);
        return "<scenario>" + body + "</scenario>";
    }
}
