package org.auvsim.cli.feed;

import de.siegmar.fastcsv.reader.CsvParseException;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.NamedCsvRecord;

import org.auvsim.core.math.Vec3;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Reads logs from CSV: a header with the columns' names, then rows in order of time. */
public final class LogReader {
    private final Path file;
    private final Map<String, String> names;
    private final LogFrame frame;

    /** A reader of {@code file} with the columns that {@code names} gives to t, x, y and z. */
    public LogReader(Path file, Map<String, String> names, LogFrame frame) {
        this.file = file;
        this.names = names;
        this.frame = frame;
    }

    /**
     * The log in the file.
     *
     * @throws LogException naming line and column of what is wrong
     * @throws IOException if the file cannot be read
     */
    public MeasuredLog read() throws LogException, IOException {
        List<MeasuredLog.Row> rows = new ArrayList<>();
        Optional<LogColumns> columns = Optional.empty();
        try (CsvReader<NamedCsvRecord> csv =
                CsvReader.builder().detectBomHeader(true).ofNamedCsvRecord(file)) {
            for (NamedCsvRecord line : csv) {
                if (columns.isEmpty()) {
                    columns = Optional.of(columns(line.getHeader()));
                }
                MeasuredLog.Row row = row(line, columns.get());
                requireLater(line, columns.get(), rows, row);
                rows.add(row);
            }
        } catch (CsvParseException e) {
            throw new LogException("%s is not CSV: %s.".formatted(file, e.getMessage()), e);
        }
        if (rows.isEmpty()) {
            throw new LogException(
                    "%s has no rows: expected a header line and rows below it.".formatted(file));
        }
        return new MeasuredLog(rows);
    }

    private LogColumns columns(List<String> header) throws LogException {
        LogColumns columns = LogColumns.of(names, header);
        List<String> wanted = new ArrayList<>(List.of(columns.t(), columns.x(), columns.y()));
        columns.z().ifPresent(wanted::add);
        for (String name : wanted) {
            if (!header.contains(name)) {
                throw new LogException(
                        "%s:1: there is no column '%s', only %s; say with --columns which to take."
                                .formatted(file, name, String.join(", ", header)));
            }
        }
        return columns;
    }

    private MeasuredLog.Row row(NamedCsvRecord line, LogColumns columns) throws LogException {
        double z = columns.z().isPresent() ? number(line, columns.z().get()) : 0;
        Vec3 position = new Vec3(number(line, columns.x()), number(line, columns.y()), z);
        return new MeasuredLog.Row(number(line, columns.t()), frame.toWorld(position));
    }

    private double number(NamedCsvRecord line, String column) throws LogException {
        String text = line.getField(column).strip();
        try {
            double number = Double.parseDouble(text);
            if (Double.isFinite(number)) {
                return number;
            }
        } catch (NumberFormatException _) {
            // said below, as for numbers that are not finite
        }
        throw at(line, column, "a number", text);
    }

    private void requireLater(
            NamedCsvRecord line,
            LogColumns columns,
            List<MeasuredLog.Row> rows,
            MeasuredLog.Row row)
            throws LogException {
        if (!rows.isEmpty() && !(row.time() > rows.getLast().time())) {
            throw at(
                    line,
                    columns.t(),
                    "a time after %s s".formatted(rows.getLast().time()),
                    line.getField(columns.t()));
        }
    }

    private LogException at(NamedCsvRecord line, String column, String expected, String found) {
        return new LogException(
                "%s:%d: column '%s': expected %s, but found '%s'."
                        .formatted(file, line.getStartingLineNumber(), column, expected, found));
    }
}
