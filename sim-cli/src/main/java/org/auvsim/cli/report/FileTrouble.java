package org.auvsim.cli.report;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/** Why a file could not be read or written, in a sentence; the system's own words are a path. */
public final class FileTrouble {
    private FileTrouble() {}

    /** A file that should have been read. */
    public static UserError reading(Path file, IOException e) {
        return new UserError(
                "Cannot read %s: %s.".formatted(file, reason(file, e, "there is no such file")), e);
    }

    /** A file that should have been written. */
    public static UserError writing(Path file, IOException e) {
        return new UserError(
                "Cannot write %s: %s.".formatted(file, reason(file, e, noFolder(file))), e);
    }

    private static String noFolder(Path file) {
        Path folder = file.toAbsolutePath().getParent();
        return folder != null && Files.isDirectory(folder)
                ? "nothing can be made there; give another place"
                : "its folder does not exist";
    }

    private static String reason(Path file, IOException e, String ifMissing) {
        return switch (e) {
            case NoSuchFileException _ -> ifMissing;
            case AccessDeniedException _ -> "you may not";
            case FileAlreadyExistsException there when there.getFile().equals(file.toString()) ->
                    "something else of that name is there; give another name";
            case FileAlreadyExistsException there -> there.getFile() + " is in the way";
            case DirectoryNotEmptyException there ->
                    there.getFile() + " is a folder in which there is something";
            case FileSystemException trouble when trouble.getReason() != null ->
                    trouble.getReason();
            default -> String.valueOf(e.getMessage());
        };
    }
}
