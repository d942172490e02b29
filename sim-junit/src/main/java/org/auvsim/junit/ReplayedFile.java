package org.auvsim.junit;

import static java.util.Objects.requireNonNull;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.DocumentKind;
import org.auvsim.auvsml.document.Scenario;
import org.auvsim.auvsml.document.ScenarioLoader;

import java.io.IOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/**
 * A file that a test names.
 *
 * @param name as the test has it
 * @param loader of the test's classes, among which effects and messages of its own may be
 */
record ReplayedFile(String name, Path path, ClassLoader loader) {
    /**
     * The resource or file of that name.
     *
     * @throws ReplayException if there is neither
     */
    static ReplayedFile of(String name, Class<?> test) throws ReplayException {
        Optional<URL> resource = Optional.ofNullable(test.getResource(name));
        if (resource.isPresent()) {
            return new ReplayedFile(name, file(name, resource.get()), test.getClassLoader());
        }
        Path file = Path.of(name);
        if (!Files.isRegularFile(file)) {
            throw new ReplayException(
                    ("@ReplayScenario of %s names %s, which is neither a resource (relative to"
                                    + " its class) nor a file (relative to %s).")
                            .formatted(test.getName(), name, Path.of("").toAbsolutePath()));
        }
        return new ReplayedFile(name, file, test.getClassLoader());
    }

    private static Path file(String name, URL resource) throws ReplayException {
        try {
            URI uri = resource.toURI();
            if (uri.getScheme().equals("file")) {
                return Path.of(uri);
            }
        } catch (URISyntaxException e) {
            throw new ReplayException("The resource %s has no path.".formatted(name), e);
        }
        throw new ReplayException(
                "@ReplayScenario names %s, which is inside %s; only files can be replayed."
                        .formatted(name, resource));
    }

    /**
     * Runs it.
     *
     * @param until world time (s) of the end; NaN if the test names none
     * @throws ReplayException if that cannot be done
     */
    Observed replay(double until) throws ReplayException {
        return isRecording()
                ? new RecordingRun(this, until).replay()
                : new ScenarioRun(name, scenario(), until).replay();
    }

    private boolean isRecording() throws ReplayException {
        try {
            return DocumentKind.of(path) == DocumentKind.RECORDING;
        } catch (IOException e) {
            throw new ReplayException("%s cannot be read: %s".formatted(name, e.getMessage()), e);
        }
    }

    private Scenario scenario() throws ReplayException {
        try {
            return ScenarioLoader.load(loader).load(path);
        } catch (DocumentException e) {
            throw new ReplayException(requireNonNull(e.getMessage()), e);
        }
    }
}
