package org.auvsim.auvsml.run;

import org.auvsim.core.description.Default;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * How the columns of measured runs are to be read: a document of its own, which any number of runs
 * may share.
 *
 * @param axes of positions, orientations and velocities
 * @param degrees whether angles and their rates are in degrees
 * @param ignoreOthers whether columns with unknown names are left out
 * @param start how the body moved at the first row of each run whose document does not say so
 * @param shaking the columns that tell how the body shakes; empty: nothing is asked of that
 * @param column those whose name or unit is another
 */
public record ColumnMapping(
        @Default("ENU") MeasuredAxes axes,
        @Default("0") boolean degrees,
        @Default("0") boolean ignoreOthers,
        Optional<RunStart> start,
        Optional<ShakingColumns> shaking,
        List<MappedColumn> column) {
    /** Columns have their usual names and units. */
    public static final ColumnMapping USUAL =
            new ColumnMapping(MeasuredAxes.ENU, false, false, Optional.empty(), List.of());

    /** Of which nothing tells how the body shakes. */
    public ColumnMapping(
            MeasuredAxes axes,
            boolean degrees,
            boolean ignoreOthers,
            Optional<RunStart> start,
            List<MappedColumn> column) {
        this(axes, degrees, ignoreOthers, start, Optional.empty(), column);
    }

    /**
     * A checked mapping.
     *
     * @throws IllegalArgumentException if a column is mapped twice
     */
    public ColumnMapping {
        column = List.copyOf(column);
        List<String> names = column.stream().map(MappedColumn::name).toList();
        for (String name : names) {
            if (names.indexOf(name) != names.lastIndexOf(name)) {
                throw new IllegalArgumentException("column '%s' is mapped twice".formatted(name));
            }
        }
    }

    /** The same with positions, orientations and velocities in other axes. */
    public ColumnMapping in(MeasuredAxes other) {
        return new ColumnMapping(other, degrees, ignoreOthers, start, shaking, column);
    }

    /** The same with angles in degrees. */
    public ColumnMapping inDegrees() {
        return new ColumnMapping(axes, true, ignoreOthers, start, shaking, column);
    }

    /** The same, columns with unknown names left out. */
    public ColumnMapping ignoringOthers() {
        return new ColumnMapping(axes, degrees, true, start, shaking, column);
    }

    /** The same with columns that replace what it says of those of their names. */
    public ColumnMapping with(List<MappedColumn> more) {
        List<String> replaced = more.stream().map(MappedColumn::name).toList();
        Stream<MappedColumn> kept = column.stream().filter(c -> !replaced.contains(c.name()));
        List<MappedColumn> all = new ArrayList<>(kept.toList());
        all.addAll(more);
        return new ColumnMapping(axes, degrees, ignoreOthers, start, shaking, all);
    }
}
