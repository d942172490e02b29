package org.auvsim.diagnosis.reading;

import de.siegmar.fastcsv.reader.CloseableIterator;
import de.siegmar.fastcsv.reader.CsvParseException;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.CsvRecord;
import de.siegmar.fastcsv.reader.FieldMismatchStrategy;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.document.MissingFile;

import java.io.BufferedReader;
import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;

/** A table in a file, read row by row: a long one needs no more memory than a short one. */
final class CsvTable implements Closeable {
    /** No column has a longer name. */
    private static final int LONGEST_NAME = 200;

    private static final Pattern NUMBER = Pattern.compile("[+-]?\\d*\\.?\\d+([eE][+-]?\\d+)?");
    private static final Pattern SEPARATED_OTHERWISE = Pattern.compile("^#|[\\s|]");

    private final Path file;
    private final CloseableIterator<CsvRecord> rows;
    private final List<String> header;
    private final char separator;

    private CsvTable(Path file) throws IOException, DocumentException {
        this.file = file;
        this.separator = separator(file);
        CsvReader<CsvRecord> csv =
                CsvReader.builder()
                        .detectBomHeader(true)
                        .fieldSeparator(separator)
                        .missingFieldStrategy(FieldMismatchStrategy.IGNORE)
                        .extraFieldStrategy(FieldMismatchStrategy.IGNORE)
                        .ofCsvRecord(file);
        rows = csv.iterator();
        try {
            header = header();
        } catch (IOException | DocumentException | RuntimeException e) {
            close();
            throw e;
        }
    }

    /**
     * Opens a file and reads its header.
     *
     * @throws DocumentException if it cannot be read or has no header
     */
    static CsvTable open(Path file) throws DocumentException {
        try {
            return new CsvTable(file);
        } catch (IOException | UncheckedIOException e) {
            throw unreadable(file, e);
        }
    }

    /** The sentence on a file that the system does not give. */
    static DocumentException unreadable(Path file, Exception e) {
        if (e instanceof UncheckedIOException wrapped) {
            return because(Objects.requireNonNull(wrapped.getCause()), file);
        }
        return because(e, file);
    }

    private static DocumentException because(Throwable reason, Path file) {
        return switch (reason) {
            case NoSuchFileException _ -> new DocumentException(MissingFile.sentence(file), reason);
            case CharacterCodingException _ ->
                    new DocumentException(
                            file + " is not UTF-8 text, which CSV must be: save it as UTF-8",
                            reason);
            case AccessDeniedException _ ->
                    new DocumentException(
                            file + " cannot be read: permission denied; change its permissions",
                            reason);
            default ->
                    new DocumentException(
                            Files.isDirectory(file)
                                    ? file + " is a folder; expected a file, name one in it"
                                    : file + " cannot be read: " + reason.getMessage(),
                            reason);
        };
    }

    /** The comma; or a semicolon or tab, if the header has that and no comma. */
    private static char separator(Path file) throws IOException {
        try (BufferedReader in = Files.newBufferedReader(file)) {
            String first = Optional.ofNullable(in.readLine()).orElse("");
            for (char other : new char[] {';', '\t'}) {
                if (first.indexOf(',') < 0 && first.indexOf(other) >= 0) {
                    return other;
                }
            }
            return ',';
        }
    }

    private List<String> header() throws IOException, DocumentException {
        CsvRecord first =
                next().orElseThrow(
                                () ->
                                        new DocumentException(
                                                file
                                                        + " is empty: expected a header line with"
                                                        + " the columns' names and rows below it"));
        List<String> names = first.getFields().stream().map(String::strip).toList();
        if (names.getFirst().startsWith("<")) {
            throw new DocumentException(
                    file
                            + ":1: is XML, and no run: expected CSV, a header line with the"
                            + " columns' names and rows below it; a run's document is read"
                            + " automatically; give the run's CSV file instead");
        }
        if (names.stream().anyMatch(CsvTable::isNoName)) {
            throw new DocumentException(
                    file
                            + ":1: is no CSV: expected a header line with the columns' names, with"
                            + " commas between them; give the file with the run's rows");
        }
        if (names.stream().allMatch(name -> NUMBER.matcher(name).matches())) {
            throw new DocumentException(
                    file
                            + ":1: has numbers where a header line was expected: write one with the"
                            + " columns' names above the rows, as t,x,y,z");
        }
        if (names.size() == 1 && SEPARATED_OTHERWISE.matcher(names.getFirst()).find()) {
            throw new DocumentException(
                    "%s:1: is one column, '%s': expected a header line with commas, semicolons or tabs between the columns' names; separate all rows so, and take comments out"
                            .formatted(file, names.getFirst()));
        }
        Set<String> seen = new HashSet<>();
        for (String name : names) {
            if (!seen.add(name)) {
                throw at(
                        first.getStartingLineNumber(),
                        name,
                        "this name is in the header twice; give each column its own name");
            }
        }
        return names;
    }

    private static boolean isNoName(String name) {
        return name.length() > LONGEST_NAME || name.chars().anyMatch(Character::isISOControl);
    }

    /** What it is read from. */
    Path file() {
        return file;
    }

    /** The names of the columns. */
    List<String> columns() {
        return header;
    }

    /**
     * The next row, which has a field for each column; empty at the end.
     *
     * @throws DocumentException if it is no CSV or has another number of fields
     */
    Optional<CsvRecord> row() throws DocumentException {
        Optional<CsvRecord> row;
        try {
            row = next();
        } catch (UncheckedIOException e) {
            throw unreadable(file, e);
        }
        if (row.isPresent() && row.get().getFieldCount() != header.size()) {
            boolean hasCommas = looksLikeDecimalCommas(row.get());
            throw new DocumentException(
                    "%s:%d: expected %d fields as in the header, but found %d%s"
                            .formatted(
                                    file,
                                    row.get().getStartingLineNumber(),
                                    header.size(),
                                    row.get().getFieldCount(),
                                    hasCommas
                                            ? ": do its numbers have decimal commas? Write 1.5, not"
                                                    + " 1,5"
                                            : row.get().getFieldCount() > header.size()
                                                    ? "; is there a comma in a number, or a column"
                                                            + " without a name?"
                                                    : "; complete the row, or take it out if the"
                                                            + " file was cut off"));
        }
        return row;
    }

    /** Whether a row has too many numbers, and no decimal point in any of them. */
    private boolean looksLikeDecimalCommas(CsvRecord row) {
        return separator == ','
                && row.getFieldCount() > header.size()
                && row.getFields().stream()
                        .allMatch(cell -> cell.strip().matches("([+-]?\\d+([eE][+-]?\\d+)?)?"));
    }

    private Optional<CsvRecord> next() throws DocumentException {
        try {
            return rows.hasNext() ? Optional.of(rows.next()) : Optional.empty();
        } catch (CsvParseException e) {
            throw new DocumentException("%s is not CSV: %s".formatted(file, e.getMessage()), e);
        }
    }

    /** A fault in a row and column of this file. */
    DocumentException at(long line, String column, String problem) {
        return new DocumentException(
                "%s:%d: column '%s': %s".formatted(file, line, column, problem));
    }

    @Override
    public void close() throws IOException {
        rows.close();
    }
}
