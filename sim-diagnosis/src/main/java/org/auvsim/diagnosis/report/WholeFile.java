package org.auvsim.diagnosis.report;

import java.io.IOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;

/** Files that are there whole or not at all: written under another name, then renamed. */
final class WholeFile {
    private WholeFile() {}

    /** Something that writes a text. */
    interface Text {
        void writeTo(Writer out) throws IOException;
    }

    static void write(Path file, Text text) throws IOException {
        Path draft = file.resolveSibling(file.getFileName() + ".part");
        try {
            try (Writer out = Files.newBufferedWriter(draft)) {
                text.writeTo(out);
            }
            Files.move(draft, file, StandardCopyOption.REPLACE_EXISTING);
        } finally {
            Files.deleteIfExists(draft);
        }
    }
}
