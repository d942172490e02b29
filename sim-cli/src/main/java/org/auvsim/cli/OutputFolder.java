package org.auvsim.cli;

import org.auvsim.cli.report.FileTrouble;
import org.auvsim.cli.report.UserError;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Where the results of long work will go, tried before it begins. */
final class OutputFolder {
    private OutputFolder() {}

    /**
     * Refuses a folder in which no file could be made. Nothing is left behind, no folder either:
     * who ends the work early is not to find an empty one.
     */
    static void requireWritable(Path folder) {
        Path there = nearest(folder);
        if (!Files.isDirectory(there)) {
            throw FileTrouble.writing(folder, new FileAlreadyExistsException(there.toString()));
        }
        try {
            Files.delete(Files.createTempFile(there, "auvsim", ".part"));
        } catch (IOException e) {
            throw new UserError(
                    "Cannot write %s: no file can be made in %s; give another folder (--out), or change the permissions of this one."
                            .formatted(folder, there),
                    e);
        }
    }

    /** The folder, or that of its parents which is there already. */
    private static Path nearest(Path folder) {
        Path there = folder;
        while (Files.notExists(there)) {
            Path parent = there.getParent();
            there = parent == null ? there.toAbsolutePath().getRoot() : parent;
        }
        return there;
    }
}
