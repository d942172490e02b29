package org.auvsim.auvsml.document;

import ch.randelshofer.fastdoubleparser.JavaDoubleParser;

import de.siegmar.fastcsv.reader.CsvParseException;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.NamedCsvRecord;

import org.auvsim.core.field.GriddedCurrent;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * A CSV file with the points of a grid in rows of any order: the columns x, y, z (m) say where, u,
 * v, w (m/s) how the water moves there.
 */
final class GridFile {
    private static final List<String> COLUMNS = List.of("x", "y", "z", "u", "v", "w");

    private final Path file;

    GridFile(Path file) {
        this.file = file;
    }

    /**
     * The current with the numbers of the file.
     *
     * @throws GridFileException if it cannot be read, or what it has is no grid
     */
    GriddedCurrent read(GriddedCurrent current) throws GridFileException {
        if (Files.isDirectory(file)) {
            throw new GridFileException(file + " is a folder; expected a CSV file");
        }
        List<GridRow> rows = new ArrayList<>();
        try (CsvReader<NamedCsvRecord> csv =
                CsvReader.builder().detectBomHeader(true).ofNamedCsvRecord(file)) {
            for (NamedCsvRecord line : csv) {
                if (rows.isEmpty()) {
                    requireColumns(line.getHeader());
                }
                rows.add(row(line));
            }
        } catch (CsvParseException e) {
            throw new GridFileException("%s is not CSV: %s".formatted(file, e.getMessage()));
        } catch (NoSuchFileException _) {
            throw new GridFileException("there is no file " + file);
        } catch (IOException | UncheckedIOException e) {
            throw new GridFileException("%s cannot be read: %s".formatted(file, e.getMessage()));
        }
        if (rows.isEmpty()) {
            throw new GridFileException(
                    "%s has no points: expected the header x,y,z,u,v,w and a row for each point"
                            .formatted(file));
        }
        return new Grid(file, rows).current(current);
    }

    private void requireColumns(List<String> header) throws GridFileException {
        List<String> found = header.stream().map(String::strip).toList();
        for (int c = 0; c < found.size(); c++) {
            String column = found.get(c);
            if (!COLUMNS.contains(column)) {
                throw wrongColumns("column %d, '%s', is none of them".formatted(c + 1, column));
            }
        }
        for (String column : COLUMNS) {
            if (!found.contains(column)) {
                throw wrongColumns("there is no column '%s'".formatted(column));
            }
        }
    }

    private GridFileException wrongColumns(String what) {
        return new GridFileException(
                "%s:1: expected the columns x, y, z, u, v, w, but %s".formatted(file, what));
    }

    private GridRow row(NamedCsvRecord line) throws GridFileException {
        List<String> header = line.getHeader();
        double[] numbers = new double[COLUMNS.size()];
        for (int c = 0; c < header.size(); c++) {
            String column = header.get(c).strip();
            if (c >= line.getFieldCount()) {
                throw new GridFileException(
                        "%s:%d: the row ends before its column %d, '%s'"
                                .formatted(file, line.getStartingLineNumber(), c + 1, column));
            }
            numbers[COLUMNS.indexOf(column)] = number(line, c, column);
        }
        return new GridRow(line.getStartingLineNumber(), numbers);
    }

    private double number(NamedCsvRecord line, int c, String column) throws GridFileException {
        String text = line.getField(c).strip();
        try {
            double number = JavaDoubleParser.parseDouble(text);
            if (Double.isFinite(number)) {
                // So that -0 and 0 are one place.
                return number + 0.0;
            }
        } catch (NumberFormatException _) {
            // said below, as for numbers that are not finite
        }
        throw new GridFileException(
                "%s:%d: column %d, '%s': expected a finite number, but found '%s'"
                        .formatted(file, line.getStartingLineNumber(), c + 1, column, text));
    }
}
