package org.auvsim.cli.export;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/** What tables are written as. */
public enum ExportFormat {
    /** A folder of CSV files, one a table. */
    CSV {
        @Override
        List<Path> files(Path out) {
            return Stream.of(Table.values())
                    .map(table -> out.resolve(CsvTables.fileName(table)))
                    .toList();
        }

        @Override
        Optional<String> obstacle(Path out) {
            return Files.exists(out) && !Files.isDirectory(out)
                    ? Optional.of("csv needs a folder, but %s is a file".formatted(out))
                    : super.obstacle(out);
        }

        @Override
        TableWriter begin(Path draft) throws IOException {
            return new CsvTables(Files.createDirectory(draft));
        }
    },
    /** An SQLite database. */
    SQLITE {
        @Override
        List<Path> files(Path out) {
            return List.of(out);
        }

        @Override
        TableWriter begin(Path draft) throws IOException {
            return new SqliteTables(Files.createFile(draft));
        }
    };

    /** The files that an export makes. */
    abstract List<Path> files(Path out);

    /** What cannot be written over, as a sentence without a full stop; empty if nothing is. */
    Optional<String> obstacle(Path out) {
        return files(out).stream()
                .filter(Files::isDirectory)
                .findFirst()
                .map(
                        folder ->
                                "%s needs a file, but %s is a folder"
                                        .formatted(formatName(), folder));
    }

    private String formatName() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Begins to write the files of {@code draft}, of which none is there. */
    abstract TableWriter begin(Path draft) throws IOException;
}
