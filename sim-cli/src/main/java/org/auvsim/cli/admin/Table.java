package org.auvsim.cli.admin;

import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Records as rows below the names of their components. */
final class Table {
    private Table() {}

    /** The values of a list component; says so if there are none. */
    static String of(RecordComponent list, List<?> records) {
        if (records.isEmpty()) {
            return "no " + PlainText.name(list) + "s";
        }
        RecordComponent[] columns = records.getFirst().getClass().getRecordComponents();
        List<List<String>> rows = new ArrayList<>();
        rows.add(Arrays.stream(columns).map(PlainText::name).toList());
        for (Object record : records) {
            rows.add(
                    Arrays.stream(columns)
                            .map(column -> PlainText.cell(PlainText.value(column, record)))
                            .toList());
        }
        return text(rows, columns.length);
    }

    private static String text(List<List<String>> rows, int columns) {
        int[] widths =
                IntStream.range(0, columns)
                        .map(
                                c ->
                                        rows.stream()
                                                .mapToInt(row -> row.get(c).length())
                                                .max()
                                                .orElse(0))
                        .toArray();
        return rows.stream()
                .map(
                        row ->
                                IntStream.range(0, columns)
                                        .mapToObj(c -> padded(row.get(c), widths[c]))
                                        .collect(Collectors.joining("  "))
                                        .stripTrailing())
                .collect(Collectors.joining("\n"));
    }

    private static String padded(String cell, int width) {
        return cell + " ".repeat(width - cell.length());
    }
}
