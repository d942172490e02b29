package org.auvsim.auvsml.run;

import org.auvsim.core.description.Default;
import org.auvsim.core.entity.Domain;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A column with another name or another unit than the usual: its numbers are multiplied by the
 * scale, then the offset is added.
 *
 * @param name in the header
 * @param means the usual name of what it has; empty: that is its name
 * @param scale of its numbers; empty: 1, as their unit is taken for the usual one
 * @param offset in the usual unit
 * @param form how its cells are written
 * @param ignored whether it is left out
 * @param lastingError errors of its numbers that last over rows, which add up; none: all is noise
 * @param runEnds numbers before the first of which a run ends; also where the column is ignored
 */
public record MappedColumn(
        String name,
        Optional<String> means,
        OptionalDouble scale,
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
        double factor = scale.orElse(1);
        Domain.require(factor != 0, "column '" + name + "'", "scale", factor, "other than 0", "");
    }

    /** One of a stated scale. */
    public MappedColumn(
            String name,
            Optional<String> means,
            double scale,
            double offset,
            CellForm form,
            boolean ignored,
            List<LastingError> lastingError,
            Optional<Limit> runEnds) {
        this(name, means, OptionalDouble.of(scale), offset, form, ignored, lastingError, runEnds);
    }

    /** One of a stated scale whose errors are noise. */
    public MappedColumn(
            String name,
            Optional<String> means,
            double scale,
            double offset,
            CellForm form,
            boolean ignored) {
        this(name, means, scale, offset, form, ignored, List.of(), Optional.empty());
    }

    private static MappedColumn ofUsualUnit(String name, Optional<String> means, boolean ignored) {
        return new MappedColumn(
                name,
                means,
                OptionalDouble.empty(),
                0,
                CellForm.NUMBER,
                ignored,
                List.of(),
                Optional.empty());
    }

    /** One of which nothing is said: it has what its name means, in the usual unit. */
    public static MappedColumn usual(String name) {
        return ofUsualUnit(name, Optional.empty(), false);
    }

    /** By what its numbers are multiplied. */
    public double factor() {
        return scale.orElse(1);
    }

    /** A column that has what another name means, in the usual unit. */
    public static MappedColumn renamed(String name, String means) {
        return ofUsualUnit(name, Optional.of(means), false);
    }

    /** A column that is left out. */
    public static MappedColumn ignored(String name) {
        return ofUsualUnit(name, Optional.empty(), true);
    }
}
