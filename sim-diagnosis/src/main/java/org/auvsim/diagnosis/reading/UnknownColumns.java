package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.mapping.Names;
import org.auvsim.auvsml.run.ColumnMapping;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** Columns whose names say nothing: what is said of them, all at once, and what mends them. */
final class UnknownColumns {
    private static final double RADIANS = Math.PI / 180;

    /** What people call the column that has the time. */
    private static final Pattern TIME_LIKE = Pattern.compile("(?i)time|stamp|sec");

    private final CsvTable table;
    private final ColumnMapping mapping;
    private final CommandNames known;

    /** Places, and names of what has none. */
    private final Set<Object> taken;

    /**
     * Those of a table.
     *
     * @param filled places of which the column is known
     */
    UnknownColumns(CsvTable table, ColumnMapping mapping, CommandNames known, Set<Integer> filled) {
        this.table = table;
        this.mapping = mapping;
        this.known = known;
        this.taken = new HashSet<>(filled);
        taken.addAll(table.columns());
    }

    /** The usual name that may be meant, and the factor to its unit. */
    private record Meant(String column, String usual, double scale) {
        boolean isRename() {
            return scale == 1;
        }

        String element() {
            return "<column name=\"%s\" means=\"%s\" scale=\"%s\"/>"
                    .formatted(
                            column.replace("&", "&amp;")
                                    .replace("<", "&lt;")
                                    .replace("\"", "&quot;"),
                            usual,
                            scale);
        }
    }

    /** What is said of one that a mapping says to mean what is not known. */
    DocumentException refusal(String column, String meaning) {
        List<String> near = Names.near(meaning, names());
        String usual = near.isEmpty() ? Remedy.USUAL : near.getFirst();
        return table.at(
                1,
                column,
                "it is said to mean '%s', which is an unknown name; %s where that is said (means=\"%s\" in the mapping, or --rename), ignore it %s, or give a force or actuator of '%s' that name"
                        .formatted(
                                meaning,
                                Names.meant(near)
                                        .map(asked -> asked + " Correct it")
                                        .orElse("correct it to the usual name of its quantity"),
                                usual,
                                Remedy.ignoring(List.of(column)),
                                known.body()));
    }

    /** What is said of those that no mapping names. */
    DocumentException refusal(List<String> columns) {
        if (columns.size() > 1) {
            return several(columns);
        }
        String column = columns.getFirst();
        Optional<Meant> meant = meant(column);
        if (meant.isPresent() && !meant.get().isRename()) {
            String mapped =
                    "did you mean '%s' in another unit? Map it %s"
                            .formatted(meant.get().usual(), mapping(List.of(meant.get())));
            return one(column, column, mapped);
        }
        List<String> near =
                meant.filter(m -> !m.usual().equals(Slots.TIME_NAME) || !isTimeLike(column))
                        .map(m -> List.of(m.usual()))
                        .orElseGet(() -> Names.near(column, names()));
        String usual =
                meant.map(Meant::usual).orElse(near.isEmpty() ? Remedy.USUAL : near.getFirst());
        return one(column, column, renamed(column, near, usual));
    }

    private static String renamed(String column, List<String> near, String usual) {
        return "%s %s"
                .formatted(
                        Names.meant(near)
                                .map(asked -> asked + " Rename it")
                                .orElse("rename it to the usual name of its quantity"),
                        Remedy.renaming(column, usual));
    }

    private DocumentException one(String column, String meaning, String mending) {
        return table.at(
                1,
                column,
                "unknown name '%s'; %s, ignore it %s, or give a force or actuator of '%s' that name"
                        .formatted(
                                meaning, mending, Remedy.ignoring(List.of(column)), known.body()));
    }

    private DocumentException several(List<String> columns) {
        Map<String, String> renames = new LinkedHashMap<>();
        List<Meant> others = new ArrayList<>();
        List<String> rest = new ArrayList<>();
        for (String column : columns) {
            Optional<Meant> meant = meant(column);
            if (meant.isEmpty()) {
                rest.add(column);
            } else if (meant.get().isRename()) {
                renames.put(column, meant.get().usual());
            } else {
                others.add(meant.get());
            }
        }
        List<String> mending = new ArrayList<>();
        if (!renames.isEmpty()) {
            mending.add(
                    "rename what has a usual name but for its spelling "
                            + Remedy.renaming(renames));
        }
        if (!others.isEmpty()) {
            mending.add("map what is in another unit " + mapping(others));
        }
        if (!rest.isEmpty()) {
            mending.add(
                    "%s %s, or rename what has a usual quantity %s"
                            .formatted(
                                    rest.size() == columns.size()
                                            ? "ignore them"
                                            : "ignore the others",
                                    Remedy.ignoring(rest),
                                    Remedy.renaming(rest.getFirst(), Remedy.USUAL)));
        }
        return new DocumentException(
                "%s:1: columns %s: unknown names; %s"
                        .formatted(
                                table.file(),
                                columns.stream()
                                        .map("'%s'"::formatted)
                                        .collect(Collectors.joining(", ")),
                                String.join("; ", mending)));
    }

    private static String mapping(List<Meant> columns) {
        return columns.stream()
                .map(Meant::element)
                .collect(
                        Collectors.joining(
                                "", "(--mapping FILE with <column-mapping>", "</column-mapping>)"));
    }

    private List<String> names() {
        List<String> names = new ArrayList<>(Slots.byName().keySet());
        names.addAll(known.names());
        return names;
    }

    /** Of a place that another column fills already no second one is meant. */
    private Optional<Meant> meant(String column) {
        Optional<Meant> meant =
                unit(column).or(() -> slip(column)).filter(m -> !taken.contains(place(m.usual())));
        meant.ifPresent(m -> taken.add(place(m.usual())));
        return meant;
    }

    private static Object place(String usual) {
        return Slots.byName().containsKey(usual) ? Slots.byName().get(usual) : usual;
    }

    private Optional<Meant> unit(String column) {
        for (Map.Entry<String, Integer> usual : Slots.byName().entrySet()) {
            OptionalDouble factor = UnitEndings.factor(column, usual.getKey(), usual.getValue());
            if (factor.isPresent()) {
                boolean inDegrees = mapping.degrees() && Slots.isAngular(usual.getValue());
                double scale = factor.getAsDouble() / (inDegrees ? RADIANS : 1);
                return Optional.of(new Meant(column, usual.getKey(), scale));
            }
        }
        return Optional.empty();
    }

    private Optional<Meant> slip(String column) {
        List<String> near = Names.near(column, names());
        if (near.size() == 1) {
            return Optional.of(new Meant(column, near.getFirst(), 1));
        }
        return isTimeLike(column) && near.isEmpty()
                ? Optional.of(new Meant(column, Slots.TIME_NAME, UnitEndings.ofTime(column)))
                : Optional.empty();
    }

    private static boolean isTimeLike(String column) {
        return TIME_LIKE.matcher(column).find();
    }
}
