package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.mapping.Names;
import org.auvsim.auvsml.run.CellForm;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.auvsml.run.MappedColumn;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Columns that a mapping only gives another name: each file is read with those that it has, as one
 * may have the old name and another the usual one already. What no file has is a slip.
 */
final class Renames {
    private final List<MappedColumn> columns;
    private final List<Path> files = new ArrayList<>();
    private final Set<String> there = new LinkedHashSet<>();

    /** Those of a mapping. */
    Renames(ColumnMapping mapping) {
        columns = mapping.column().stream().filter(Renames::isRename).toList();
    }

    /** Whether a column has another name, and its unit and all else are as usual. */
    static boolean isRename(MappedColumn column) {
        MappedColumn plain =
                new MappedColumn(
                        column.name(),
                        column.means(),
                        column.scale(),
                        0,
                        CellForm.NUMBER,
                        false,
                        List.of(),
                        Optional.empty());
        return column.means().isPresent() && column.factor() == 1 && column.equals(plain);
    }

    /** Whether nothing is renamed. */
    boolean isEmpty() {
        return columns.isEmpty();
    }

    /** The names of a file's columns. */
    void in(Path file, List<String> names) {
        files.add(file);
        there.addAll(names);
    }

    /**
     * Refuses a column that is in none of the files.
     *
     * @throws DocumentException naming the column, and those that there are
     */
    void require() throws DocumentException {
        for (MappedColumn column : columns) {
            if (!files.isEmpty() && !there.contains(column.name())) {
                throw new DocumentException(
                        "%s:1: column '%s': %s"
                                .formatted(files.getFirst(), column.name(), lacking(column)));
            }
        }
    }

    private String lacking(MappedColumn column) {
        String usual = column.means().orElse("");
        return "it is to be renamed to '%s', but %s; %s"
                .formatted(
                        usual,
                        files.size() == 1
                                ? "the header has none of this name"
                                : "none of the %d files has one of this name"
                                        .formatted(files.size()),
                        there.contains(usual)
                                ? "a column has that name already: leave this renaming out"
                                : thatAre(column.name(), there));
    }

    /** Columns that there are in place of one that there is not. */
    static String thatAre(String column, Collection<String> there) {
        return Names.meant(Names.near(column, there))
                .orElseGet(() -> "there are " + String.join(", ", there));
    }
}
