package org.auvsim.auvsml.run;

import org.auvsim.core.description.Default;
import org.auvsim.core.entity.Domain;

import java.util.List;
import java.util.Optional;

/**
 * A column with another name or another unit than the usual: its numbers are multiplied by the
 * scale, then the offset is added.
 *
 * @param name in the header
 * @param means the usual name of what it has; empty: that is its name
 * @param scale of its numbers
 * @param offset in the usual unit
 * @param form how its cells are written
 * @param ignored whether it is left out
 * @param lastingError errors of its numbers that last over rows, which add up; none: all is noise
 * @param runEnds numbers before the first of which a run ends; also where the column is ignored
 */
public record MappedColumn(
        String name,
        Optional<String> means,
        @Default("1.0") double scale,
        @Default("0.0") double offset,
        @Default("NUMBER") CellForm form,
        @Default("0") boolean ignored,
        List<LastingError> lastingError,
        Optional<Limit> runEnds) {
    /**
     * A checked column.
     *
     * @throws IllegalArgumentException if the scale is 0
     */
    public MappedColumn {
        lastingError = List.copyOf(lastingError);
        Domain.require(scale != 0, "column '" + name + "'", "scale", scale, "other than 0", "");
    }

    /** One whose errors are noise. */
    public MappedColumn(
            String name,
            Optional<String> means,
            double scale,
            double offset,
            CellForm form,
            boolean ignored) {
        this(name, means, scale, offset, form, ignored, List.of(), Optional.empty());
    }

    /** A column that has what another name means, in the usual unit. */
    public static MappedColumn renamed(String name, String means) {
        return new MappedColumn(name, Optional.of(means), 1, 0, CellForm.NUMBER, false);
    }

    /** A column that is left out. */
    public static MappedColumn ignored(String name) {
        return new MappedColumn(name, Optional.empty(), 1, 0, CellForm.NUMBER, true);
    }
}
