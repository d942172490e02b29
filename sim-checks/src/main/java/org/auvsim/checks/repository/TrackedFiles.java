package org.auvsim.checks.repository;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;

/** The files of a repository that are in it or would be with the next {@code git add}. */
final class TrackedFiles {
    private TrackedFiles() {}

    /** Their paths, relative to the root. */
    static List<Path> of(Path root) throws IOException, InterruptedException {
        Process git =
                new ProcessBuilder(
                                "git",
                                // A clone may belong to another user than the one who tests it.
                                "-c",
                                "safe.directory=*",
                                "ls-files",
                                "-z",
                                "--cached",
                                "--others",
                                "--exclude-standard")
                        .directory(root.toFile())
                        .redirectError(ProcessBuilder.Redirect.INHERIT)
                        .start();
        String names = new String(git.getInputStream().readAllBytes(), UTF_8);
        if (git.waitFor() != 0) {
            throw new IOException("git could not list the files of " + root);
        }
        return Arrays.stream(names.split("\0", -1))
                .filter(name -> !name.isEmpty())
                .map(Path::of)
                .filter(file -> Files.isRegularFile(root.resolve(file)))
                .distinct()
                .toList();
    }
}
