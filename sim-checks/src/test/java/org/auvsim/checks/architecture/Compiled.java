package org.auvsim.checks.architecture;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;

import org.auvsim.checks.Repository;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** The classes of all modules, as they were compiled last. */
final class Compiled {
    private Compiled() {}

    static JavaClasses main() {
        return in("classes");
    }

    static JavaClasses tests() {
        return in("test-classes");
    }

    private static JavaClasses in(String folder) {
        try (var modules = Files.list(Repository.root());
                var examples = Files.list(Repository.root().resolve("examples"))) {
            List<Path> folders =
                    Stream.concat(modules, examples)
                            .map(module -> module.resolve("target").resolve(folder))
                            .filter(Files::isDirectory)
                            .toList();
            return new ClassFileImporter().importPaths(folders);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
