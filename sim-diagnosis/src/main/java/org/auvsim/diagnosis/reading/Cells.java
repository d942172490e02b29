package org.auvsim.diagnosis.reading;

import de.siegmar.fastcsv.reader.CsvRecord;

import org.auvsim.auvsml.document.DocumentException;

import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads numbers from the cells of a table. */
final class Cells {
    private static final Pattern TIME_OF_DAY =
            Pattern.compile("(\\d{2})(\\d{2})(\\d{2}(\\.\\d*)?)");

    private static final Pattern DECIMAL_COMMA = Pattern.compile("[+-]?\\d*,\\d+([eE][+-]?\\d+)?");

    private static final String MENDING =
            "correct it, or leave the cell empty if nothing was measured";

    /** What stands in numbers of Java alone: 1.5f, 3d, 0x1p3. */
    private static final Pattern OF_JAVA = Pattern.compile("[dDfFxX]");

    private final CsvTable table;

    Cells(CsvTable table) {
        this.table = table;
    }

    /** A cell's number in the unit of its place; NaN if there is none: an empty cell, or nan. */
    double optional(CsvRecord row, BoundColumn column) throws DocumentException {
        String text = text(row, column);
        return text.isEmpty() || text.equalsIgnoreCase("nan") ? Double.NaN : number(row, column);
    }

    /** A cell's number in the unit of its place. */
    double number(CsvRecord row, BoundColumn column) throws DocumentException {
        String text = text(row, column);
        return column.converted(
                switch (column.form()) {
                    case NUMBER -> finite(row, column, text);
                    case HHMMSS -> timeOfDay(row, column, text);
                    case ISO_8601 -> date(row, column, text);
                });
    }

    static String text(CsvRecord row, BoundColumn column) {
        return row.getField(column.field()).strip();
    }

    private double finite(CsvRecord row, BoundColumn column, String text) throws DocumentException {
        try {
            double number = Double.parseDouble(text);
            if (Double.isFinite(number) && !OF_JAVA.matcher(text).find()) {
                return number;
            }
        } catch (NumberFormatException _) {
            // said below, as for numbers that are not finite
        }
        if (Iso8601.isLike(text)) {
            throw expected(
                    row,
                    column,
                    "a number",
                    "map the column with form=\"ISO-8601\" (--mapping) if these are dates and"
                            + " times");
        }
        throw column.slot() == Slots.TIME || column.slot() == Slots.RUN
                ? expected(row, column, "a number", "correct it, or take the row out")
                : expected(row, column, "a number", MENDING);
    }

    private double timeOfDay(CsvRecord row, BoundColumn column, String text)
            throws DocumentException {
        Matcher parts = TIME_OF_DAY.matcher(text);
        if (!parts.matches()) {
            throw expected(row, column, "a time of day as 205259");
        }
        return 3600.0 * Integer.parseInt(parts.group(1))
                + 60.0 * Integer.parseInt(parts.group(2))
                + Double.parseDouble(parts.group(3));
    }

    private double date(CsvRecord row, BoundColumn column, String text) throws DocumentException {
        OptionalDouble seconds = Iso8601.seconds(text);
        if (seconds.isEmpty()) {
            throw expected(
                    row,
                    column,
                    "a date and time as 2024-06-10T12:00:00.25Z",
                    "correct it, or take the row out");
        }
        return seconds.getAsDouble();
    }

    /** Something else was expected in a cell. */
    DocumentException expected(CsvRecord row, BoundColumn column, String what) {
        return table.at(
                row.getStartingLineNumber(),
                column.name(),
                "expected %s, but found '%s'".formatted(what, text(row, column)));
    }

    /** The same, with what to do. */
    DocumentException expected(CsvRecord row, BoundColumn column, String what, String whatToDo) {
        String text = text(row, column);
        return DECIMAL_COMMA.matcher(text).matches()
                ? table.at(
                        row.getStartingLineNumber(),
                        column.name(),
                        "expected %s, but found '%s': is that a decimal comma? Export the file with decimal points, and commas between columns"
                                .formatted(what, text))
                : table.at(
                        row.getStartingLineNumber(),
                        column.name(),
                        "expected %s, but found '%s'; %s".formatted(what, text, whatToDo));
    }
}
