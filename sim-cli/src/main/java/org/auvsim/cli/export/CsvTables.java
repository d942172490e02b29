package org.auvsim.cli.export;

import static java.nio.charset.StandardCharsets.UTF_8;
import static java.util.Objects.requireNonNull;

import de.siegmar.fastcsv.writer.CsvWriter;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.Map;

/** A CSV file with a header for each table, in a folder. */
final class CsvTables implements TableWriter {
    private final Map<Table, CsvWriter> files = new EnumMap<>(Table.class);

    CsvTables(Path folder) throws IOException {
        try {
            for (Table table : Table.values()) {
                Path file = folder.resolve(fileName(table));
                CsvWriter csv = CsvWriter.builder().build(Files.newBufferedWriter(file, UTF_8));
                files.put(table, csv);
                csv.writeRecord(table.columns().stream().map(Column::name).toList());
            }
        } catch (IOException | RuntimeException e) {
            close();
            throw e;
        }
    }

    static String fileName(Table table) {
        return table.sqlName() + ".csv";
    }

    @Override
    public void append(Table table, Row row) throws IOException {
        try {
            requireNonNull(files.get(table))
                    .writeRecord(
                            row.cells().stream()
                                    .map(cell -> cell.map(Object::toString).orElse(""))
                                    .toList());
        } catch (UncheckedIOException e) {
            throw new IOException(e.getMessage(), e);
        }
    }

    @Override
    public void close() throws IOException {
        for (CsvWriter csv : files.values()) {
            csv.close();
        }
    }
}
