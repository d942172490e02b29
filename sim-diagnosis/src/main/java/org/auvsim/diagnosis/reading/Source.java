package org.auvsim.diagnosis.reading;

import org.auvsim.core.entity.Frame;
import org.auvsim.diagnosis.run.Axes;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Where a run was read. What is said of a place in it begins as editors name places: {@code
 * run.csv:5: column 'y': }. A recording has no rows and columns, and is named alone. Immutable.
 */
public final class Source {
    private final Path file;
    private final long first;
    private final long last;
    private final Map<Integer, String> columns;
    private final List<String> commands;
    private final Axes axes;

    private Source(
            Path file,
            long first,
            long last,
            Map<Integer, String> columns,
            List<String> commands,
            Axes axes) {
        this.file = file;
        this.first = first;
        this.last = last;
        this.columns = columns;
        this.commands = commands;
        this.axes = axes;
    }

    /** A file without rows. */
    static Source of(Path file) {
        return new Source(file, 0, 0, Map.of(), List.of(), Axes.ENU);
    }

    /** A table, as a whole. */
    static Source of(Path file, Layout layout, Axes axes) {
        return new Source(
                file, 0, 0, Map.copyOf(layout.filled()), List.copyOf(layout.commands()), axes);
    }

    /** Some rows of it. */
    Source rows(long from, long to) {
        return new Source(file, from, to, columns, commands, axes);
    }

    /** The file. */
    public Path file() {
        return file;
    }

    /** The first row as an editor counts it, the header being row 1; 0 if there are none. */
    public long first() {
        return first;
    }

    /** The last row. */
    public long last() {
        return last;
    }

    /** Whether it is a table. */
    boolean isTable() {
        return !columns.isEmpty();
    }

    /** What is said of all of it. */
    String says(String sentence) {
        return place(first) + ": " + sentence;
    }

    /** What is said of a row and columns; a column without a name is left out. */
    String says(long row, List<String> names, String sentence) {
        String quoted =
                names.stream()
                        .filter(name -> !name.isEmpty())
                        .map("'%s'"::formatted)
                        .collect(Collectors.joining(", "));
        String which =
                quoted.isEmpty() ? "" : (quoted.contains(",") ? "columns " : "column ") + quoted;
        return place(row) + ": " + (which.isEmpty() ? "" : which + ": ") + sentence;
    }

    /** What is said of columns, from its first row on. */
    String says(List<String> names, String sentence) {
        return says(first, names, sentence);
    }

    private String place(long row) {
        return row > 0 && isTable() ? file + ":" + row : file.toString();
    }

    /** That of a sample of a run, where each row is one; else the first. */
    long row(int sample, MeasuredRun run) {
        boolean isEachRow = last() - first() + 1 == run.size();
        return isEachRow ? first() + sample : first();
    }

    /** "rows 2 to 61 ", or nothing where there are none. */
    String span() {
        return first > 0 ? "rows %d to %d ".formatted(first, last) : "";
    }

    /** The name of the column that has the time; empty if none does. */
    String time() {
        return columns.getOrDefault(Slots.TIME, "");
    }

    /** The name of the column that tells an actuator or force what to do; empty if none does. */
    String command(String name) {
        int place = commands.indexOf(name);
        return place < 0 ? "" : columns.getOrDefault(Slots.COMMANDS + place, "");
    }

    /** The column of a vector in the world's axes that is measured along an axis (0 to 2). */
    String column(Channel channel, int axis) {
        int of = axes == Axes.NED && axis < 2 ? 1 - axis : axis;
        return columns.getOrDefault(Slots.measuredBy(channel) + of, "");
    }

    /** That of a channel along an axis of the body. */
    String bodyColumn(Channel channel, int axis) {
        return columns.getOrDefault(Slots.measuredBy(channel) + axis, "");
    }

    /** That of a number of a run, in the axes in which the run has it. */
    String column(MeasuredRun run, Channel channel, int axis) {
        boolean isAlongBody =
                channel == Channel.ORIENTATION
                        || (channel != Channel.POSITION && run.frame(channel) == Frame.BODY);
        return isAlongBody ? bodyColumn(channel, axis) : column(channel, axis);
    }

    /** The column that fills a place of {@link Slots}; empty if none does. */
    String named(int slot) {
        return columns.getOrDefault(slot, "");
    }

    /** Those of a channel. */
    List<String> columns(Channel channel) {
        int first = Slots.measuredBy(channel);
        return named(IntStream.range(first, first + 3));
    }

    /** All that are measured. */
    List<String> measured() {
        return named(IntStream.range(0, Slots.COMMANDS).filter(Slots::isMeasured));
    }

    private List<String> named(IntStream slots) {
        return slots.boxed().flatMap(slot -> Stream.ofNullable(columns.get(slot))).toList();
    }
}
