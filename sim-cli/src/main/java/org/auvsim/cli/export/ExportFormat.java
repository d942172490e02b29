package org.auvsim.cli.export;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
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

    /** Begins to write the files of {@code draft}, of which none is there. */
    abstract TableWriter begin(Path draft) throws IOException;
}
