package org.auvsim.cli;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** The command line in this process, what it printed, and files for it. */
final class CommandLineHarness {
    /** The project's examples, from the module's folder in which tests run. */
    static final Path EXAMPLES = Path.of("..", "examples");

    private final Path folder;
    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    /** Puts its files in {@code folder}. */
    CommandLineHarness(Path folder) {
        this.folder = folder;
    }

    int run(Object... arguments) {
        String[] texts = List.of(arguments).stream().map(Object::toString).toArray(String[]::new);
        return Auvsim.commandLine(folder, folder)
                .setOut(new PrintWriter(out))
                .setErr(new PrintWriter(err))
                .execute(texts);
    }

    /** What was printed, with the lines' ends of this project. */
    String out() {
        return out.toString().replace(System.lineSeparator(), "\n");
    }

    /** What was printed to the standard error. */
    String err() {
        return err.toString().replace(System.lineSeparator(), "\n");
    }

    Path file(String name, String text) throws IOException {
        return Files.writeString(folder.resolve(name), text, UTF_8);
    }
}
