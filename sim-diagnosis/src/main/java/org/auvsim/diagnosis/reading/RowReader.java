package org.auvsim.diagnosis.reading;

import de.siegmar.fastcsv.reader.CsvRecord;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.core.entity.Actuator;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** Reads the numbers of rows into their places, and holds commands from row to row. */
final class RowReader {
    private static final double NEARLY_UNIT = 0.01;

    private final CsvTable table;
    private final Layout layout;
    private final CommandNames known;
    private final Cells cells;
    private final Ends ends;
    private final double[] numbers;
    private Optional<String> beyond = Optional.empty();
    private boolean isToldOtherwise;
    private boolean isOfAnotherRun;
    private double largestAngle;
    private String angleColumn = "";
    private long angleRow;
    private long line;

    RowReader(CsvTable table, Layout layout, CommandNames known) {
        this.table = table;
        this.layout = layout;
        this.known = known;
        this.cells = new Cells(table);
        this.ends = new Ends(table, layout.limited());
        numbers = new double[Slots.COMMANDS + layout.commands().size()];
        Arrays.fill(numbers, Double.NaN);
    }

    /**
     * The numbers of the next row by {@link Slots}, NaN where it has none; overwritten by that
     * after it. Empty at the end.
     *
     * @throws DocumentException naming row and column of what is wrong
     */
    Optional<double[]> next() throws DocumentException {
        Optional<CsvRecord> row = table.row();
        if (row.isEmpty()) {
            return Optional.empty();
        }
        line = row.get().getStartingLineNumber();
        isToldOtherwise = false;
        isOfAnotherRun = isOfAnotherRun(row.get());
        if (isOfAnotherRun) {
            Arrays.fill(numbers, Slots.COMMANDS, numbers.length, Double.NaN);
        }
        for (BoundColumn column : layout.columns()) {
            if (column.slot() >= Slots.COMMANDS) {
                command(row.get(), column);
            } else {
                numbers[column.slot()] =
                        column.slot() == Slots.TIME || column.slot() == Slots.RUN
                                ? cells.number(row.get(), column)
                                : cells.optional(row.get(), column);
                requireDeviation(row.get(), column);
                note(column);
            }
        }
        requireUnit(row.get());
        beyond = ends.of(row.get());
        return Optional.of(numbers);
    }

    private boolean isOfAnotherRun(CsvRecord row) throws DocumentException {
        double before = numbers[Slots.RUN];
        Optional<BoundColumn> run = layout.of(Slots.RUN);
        return run.isPresent() && !Double.isNaN(before) && cells.number(row, run.get()) != before;
    }

    /** Whether the last row told an actuator or force something else than that before. */
    boolean isToldOtherwise() {
        return isToldOtherwise;
    }

    /** What of the last row is beyond a limit, so that its run has ended before it; in words. */
    Optional<String> beyond() {
        return beyond;
    }

    /** Whether the last row says that it is of another run than that before. */
    boolean isOfAnotherRun() {
        return isOfAnotherRun;
    }

    private void note(BoundColumn column) {
        boolean isAngle = column.slot() >= Slots.ANGLES && column.slot() < Slots.ANGLES + 3;
        if (isAngle && Math.abs(numbers[column.slot()]) > largestAngle) {
            largestAngle = Math.abs(numbers[column.slot()]);
            angleColumn = column.name();
            angleRow = line;
        }
    }

    /** The largest of roll, pitch and yaw (rad) so far, without its sign. */
    double largestAngle() {
        return largestAngle;
    }

    /** The column that it stands in. */
    String angleColumn() {
        return angleColumn;
    }

    /** The row that it stands in, as an editor counts it. */
    long angleRow() {
        return angleRow;
    }

    /** The last row, as an editor counts it. */
    long line() {
        return line;
    }

    private void command(CsvRecord row, BoundColumn column) throws DocumentException {
        double held = numbers[column.slot()];
        double now = cells.optional(row, column);
        if (Double.isNaN(now)) {
            if (Double.isNaN(held)) {
                throw cells.expected(
                        row,
                        column,
                        "what is commanded where the run begins",
                        "fill in what held before, or 0");
            }
        } else if (now != held) {
            requirePossible(row, column, now);
            numbers[column.slot()] = now;
            isToldOtherwise = true;
        }
    }

    private void requirePossible(CsvRecord row, BoundColumn column, double level)
            throws DocumentException {
        String name = layout.commands().get(column.slot() - Slots.COMMANDS);
        Optional<Actuator> actuator = known.actuator(name);
        try {
            actuator.ifPresent(each -> each.commanded(level, 0));
        } catch (IllegalArgumentException e) {
            throw table.at(
                    row.getStartingLineNumber(),
                    column.name(),
                    "%s (found '%s'); map the column with a scale and an offset if it has another unit"
                            .formatted(e.getMessage(), Cells.text(row, column)));
        }
    }

    private void requireDeviation(CsvRecord row, BoundColumn column) throws DocumentException {
        if (Slots.isDeviation(column.slot()) && numbers[column.slot()] <= 0) {
            throw cells.expected(
                    row,
                    column,
                    "a standard deviation above 0",
                    "leave the cell empty where none is known, or ignore the column "
                            + Remedy.ignoring(List.of(column.name())));
        }
    }

    private void requireUnit(CsvRecord row) throws DocumentException {
        double w = numbers[Slots.QUATERNION];
        double x = numbers[Slots.QUATERNION + 1];
        double y = numbers[Slots.QUATERNION + 2];
        double z = numbers[Slots.QUATERNION + 3];
        if (Double.isNaN(w) && Double.isNaN(x) && Double.isNaN(y) && Double.isNaN(z)) {
            return;
        }
        double length = Math.sqrt(w * w + x * x + y * y + z * z);
        if (Double.isNaN(length)) {
            throw ofQuaternion(
                    row, "expected four numbers of the quaternion, or none, but some are missing");
        }
        if (!(Math.abs(length - 1) <= NEARLY_UNIT)) {
            throw ofQuaternion(
                    row,
                    "expected a quaternion of length 1 (within %s), but its length is %s; are its columns in order and unscaled?"
                            .formatted(NEARLY_UNIT, Figures.shown(length)));
        }
    }

    private DocumentException ofQuaternion(CsvRecord row, String problem) {
        return table.at(row.getStartingLineNumber(), layout.nameOf(Slots.QUATERNION), problem);
    }
}
