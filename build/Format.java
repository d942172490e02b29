import static java.util.stream.Collectors.joining;

import com.google.googlejavaformat.java.Formatter;
import com.google.googlejavaformat.java.FormatterException;
import com.google.googlejavaformat.java.ImportOrderer;
import com.google.googlejavaformat.java.JavaFormatterOptions;
import com.google.googlejavaformat.java.JavaFormatterOptions.Style;
import com.google.googlejavaformat.java.RemoveUnusedImports;
import com.google.googlejavaformat.java.StringWrapper;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Checks, or mends, the form of every Java file of the repository: google-java-format, AOSP style.
 *
 * <p>A program of its own, because the formatter parses with the Java that it runs in, and Maven's
 * own may be too old for our sources.
 */
public final class Format {
    private static final Style STYLE = Style.AOSP;
    private static final Formatter FORMATTER =
            new Formatter(JavaFormatterOptions.builder().style(STYLE).build());

    private Format() {}

    /** Arguments: {@code check} or {@code mend}, then the repository's root. */
    public static void main(String[] arguments) throws IOException {
        boolean mend = arguments[0].equals("mend");
        Path root = Path.of(arguments[1]);
        List<Path> wrong =
                sources(root).parallelStream().filter(file -> !isFormed(file, mend)).toList();
        if (mend || wrong.isEmpty()) {
            return;
        }
        System.err.printf(
                "Not in google-java-format (AOSP style): %s. Mend with: mvn -q -pl build -Pformat"
                        + " validate%n",
                wrong.stream().map(root::relativize).map(Path::toString).collect(joining(", ")));
        System.exit(1);
    }

    private static List<Path> sources(Path root) throws IOException {
        try (var files = Files.walk(root)) {
            return files.filter(file -> file.toString().endsWith(".java"))
                    .filter(file -> isOurs(root.relativize(file)))
                    .sorted()
                    .toList();
        }
    }

    /** Whether no folder on the way is hidden or a build's output. */
    private static boolean isOurs(Path file) {
        for (Path part : file) {
            if (part.toString().matches("target|[.].+")) {
                return false;
            }
        }
        return true;
    }

    private static boolean isFormed(Path file, boolean mend) {
        try {
            String text = Files.readString(file);
            String formed = form(text);
            if (mend && !formed.equals(text)) {
                Files.writeString(file, formed);
            }
            return formed.equals(text);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (FormatterException e) {
            System.err.println(file + " is not Java: " + e.getMessage());
            return false;
        }
    }

    private static String form(String text) throws FormatterException {
        String imports =
                ImportOrderer.reorderImports(RemoveUnusedImports.removeUnusedImports(text), STYLE);
        return StringWrapper.wrap(FORMATTER.formatSource(imports), FORMATTER);
    }
}
