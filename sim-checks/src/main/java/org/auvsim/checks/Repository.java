package org.auvsim.checks;

import java.nio.file.Files;
import java.nio.file.Path;

/** The repository that the tests run in. */
public final class Repository {
    private Repository() {}

    /** Its root: the nearest folder above that holds the launcher. */
    public static Path root() {
        Path folder = Path.of("").toAbsolutePath();
        while (!Files.isRegularFile(folder.resolve("auvsim"))) {
            Path parent = folder.getParent();
            if (parent == null) {
                throw new IllegalStateException("run inside the repository");
            }
            folder = parent;
        }
        return folder;
    }
}
