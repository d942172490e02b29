package org.auvsim.cli.export;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.recording.RecordingReader;
import org.auvsim.auvsml.mapping.AuvsmlMapper;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A recording's tables in files, which appear all at once or, if something goes wrong, not at all.
 *
 * @param out the folder or file that is to be made
 */
public record RecordingExport(ExportFormat format, Path out) {
    /** The first of its files that exists already. */
    public Optional<Path> existing() {
        return format.files(out).stream().filter(Files::exists).findFirst();
    }

    /** What is in the way and cannot be written over, as a sentence without a full stop. */
    public Optional<String> obstacle() {
        return format.obstacle(out);
    }

    /** Whether one of the files that it writes or removes is this one. */
    public boolean destroys(Path file) throws IOException {
        Path draft = draft();
        List<Path> written = new ArrayList<>(format.files(out));
        written.addAll(format.files(draft));
        written.add(draft);
        for (Path path : written) {
            if (Files.exists(path) && Files.exists(file) && Files.isSameFile(path, file)) {
                return true;
            }
        }
        return false;
    }

    private Path draft() {
        return out.resolveSibling(out.getFileName() + ".part");
    }

    /**
     * Writes the tables of a recording, in place of such files as there are.
     *
     * @return how many rows each has
     * @throws DocumentException if the recording is damaged
     * @throws IOException if a file cannot be written
     */
    public Map<Table, Long> write(RecordingReader recording, AuvsmlMapper mapper)
            throws DocumentException, IOException {
        Path draft = draft();
        try {
            remove(draft);
            Map<Table, Long> rows;
            try (TableWriter tables = format.begin(draft)) {
                rows = new RecordingTables(mapper, tables).write(recording);
            }
            publish(draft);
            return rows;
        } finally {
            remove(draft);
        }
    }

    private void publish(Path draft) throws IOException {
        List<Path> from = format.files(draft);
        List<Path> to = format.files(out);
        for (int i = 0; i < to.size(); i++) {
            Path parent = to.get(i).toAbsolutePath().getParent();
            if (parent != null && !Files.isDirectory(parent)) {
                Files.createDirectory(parent);
            }
            Files.move(from.get(i), to.get(i), StandardCopyOption.REPLACE_EXISTING);
        }
    }

    /** Removes the files of a draft, also what an export that was killed left behind. */
    private void remove(Path draft) throws IOException {
        for (Path file : format.files(draft)) {
            Files.deleteIfExists(file);
        }
        Files.deleteIfExists(draft);
    }
}
