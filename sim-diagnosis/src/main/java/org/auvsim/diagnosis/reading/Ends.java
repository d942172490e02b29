package org.auvsim.diagnosis.reading;

import de.siegmar.fastcsv.reader.CsvRecord;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.run.Limit;

import java.util.List;
import java.util.Optional;

/** The rows before which runs end: those in which a column is beyond its limit. */
final class Ends {
    private final Cells cells;
    private final List<LimitedColumn> columns;

    /**
     * A column with a limit, both in its usual unit.
     *
     * @param column whose place does not matter
     */
    record LimitedColumn(BoundColumn column, Limit limit) {}

    Ends(CsvTable table, List<LimitedColumn> columns) {
        this.cells = new Cells(table);
        this.columns = columns;
    }

    /**
     * What of a row is beyond its limit, in words; empty if nothing is.
     *
     * @throws DocumentException naming row and column of what is no number
     */
    Optional<String> of(CsvRecord row) throws DocumentException {
        for (LimitedColumn each : columns) {
            double number = cells.optional(row, each.column());
            if (each.limit().isPassedBy(number)) {
                return Optional.of(
                        "'%s' is %s".formatted(each.column().name(), Figures.shown(number)));
            }
        }
        return Optional.empty();
    }
}
