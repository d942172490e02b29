package org.auvsim.diagnosis.reading;

import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * Makes runs of the rows of one file: a long gap ends one and begins another, and of more rows than
 * are needed some are left out. Rows that tell something anew always count; of those that would
 * have been left out otherwise, only the commands do, so that what is measured stays evenly spaced.
 */
final class RunParts {
    /** Samples of what is measured that are kept of a file, about. */
    static final int MOST = 20_000;

    /** A gap is longer than so many usual intervals, and than a second. */
    private static final double INTERVALS = 10;

    private static final double LEAST_GAP = 1;

    private final String name;
    private final Source source;
    private final List<String> commands;
    private final RowSample samples;
    private final double longest;
    private final long each;
    private final Thinning thinning;
    private final boolean keepsCommands;
    private final Consumer<MeasuredRunBuilder> known;
    private final List<String> notices = new ArrayList<>();
    private final List<MeasuredRunBuilder> parts = new ArrayList<>();
    private final List<Source> sources = new ArrayList<>();
    private Optional<MeasuredRunBuilder> part = Optional.empty();
    private int inPart;
    private double first;
    private double last;
    private long row;
    private long line;
    private long firstLine;
    private long lastLine;
    private Optional<Source> longestPart = Optional.empty();
    private int inLongest;

    /** Whether the run has ended before its last row. */
    private boolean hasEnded;

    /** Whether a gap came before. */
    private boolean isUnderWay;

    /**
     * For so many rows.
     *
     * @param source where they are
     * @param known tells a run what its document says
     */
    RunParts(
            String name,
            Source source,
            List<String> commands,
            RowSample samples,
            Extent extent,
            Consumer<MeasuredRunBuilder> known) {
        this.name = name;
        this.source = source;
        this.commands = commands;
        this.samples = samples;
        this.known = known;
        longest = Math.max(INTERVALS * extent.interval(), LEAST_GAP);
        each = (extent.rows() + MOST - 1) / MOST;
        thinning = new Thinning(each);
        keepsCommands = extent.changes() <= MOST;
        tellLeftOut(extent);
    }

    private void tellLeftOut(Extent extent) {
        if (each == 1) {
            return;
        }
        notices.add(
                source.says(
                        "every %s of %d rows is used, %s"
                                .formatted(
                                        Ordinal.of(each),
                                        extent.rows(),
                                        keepsCommands
                                                ? "plus all rows in which a command changes"
                                                : "its commands included; command changes in"
                                                        + " between are left out, as there are %d"
                                                                .formatted(extent.changes()))));
    }

    /** The row that comes next stands there in the file. */
    void from(long line) {
        this.line = line;
    }

    /**
     * Takes a row.
     *
     * @param isMeasured whether it has more than commands
     * @param isToldOtherwise whether its commands differ from those of the row before
     */
    void add(double time, double[] numbers, boolean isMeasured, boolean isToldOtherwise) {
        if (part.isPresent() && time - last > longest) {
            notices.add(
                    source.says(
                            line,
                            List.of(source.time()),
                            "%s s without a row after %s s; what follows is read as another run"
                                    .formatted(
                                            Figures.shown(time - last), Figures.shown(last, 9))));
            end();
            isUnderWay = true;
        }
        if (hasEnded) {
            return;
        }
        if (part.isEmpty()) {
            thinning.restart();
            row = 0;
        }
        boolean counts = isMeasured && thinning.takes(row, numbers);
        if (counts || (part.isPresent() && keepsCommands && isToldOtherwise)) {
            MeasuredRunBuilder run = part.orElseGet(() -> begin(time));
            run.at(time);
            for (int i = 0; i < commands.size(); i++) {
                run.command(i, numbers[Slots.COMMANDS + i]);
            }
            if (counts) {
                samples.addMeasured(thinning.taken(), run);
                inPart++;
            }
        }
        if (isMeasured) {
            last = time;
            lastLine = line;
            row++;
        }
    }

    /**
     * The run ends before a row, and what follows of it is left out.
     *
     * @param why in words
     */
    void endBefore(double time, String why) {
        if (!hasEnded) {
            notices.add(
                    source.says(
                            line,
                            List.of(),
                            "the run ends %s s after its first row, where %s; what follows is left out"
                                    .formatted(
                                            Figures.shown(part.isPresent() ? time - first : 0),
                                            why)));
            end();
            hasEnded = true;
        }
    }

    /** What follows is of another run. */
    void restart() {
        end();
        hasEnded = false;
        isUnderWay = false;
    }

    private MeasuredRunBuilder begin(double time) {
        String partName = parts.isEmpty() ? name : name + "-" + (parts.size() + 1);
        MeasuredRunBuilder run = MeasuredRun.named(partName).commands(commands);
        if (isUnderWay) {
            run.beginningMidway();
        }
        samples.tell(run);
        known.accept(run);
        part = Optional.of(run);
        firstLine = line;
        first = time;
        inPart = 0;
        return run;
    }

    private void end() {
        Source rows = source.rows(firstLine, lastLine);
        if (part.isPresent() && inPart >= MeasuredRun.FEWEST) {
            parts.add(part.get());
            sources.add(rows);
        } else if (part.isPresent()) {
            String span = rows.span().isEmpty() ? "what comes " : rows.span();
            notices.add(
                    rows.says(
                            "%sbefore a gap or the end has only %d samples, and is left out; expected at least %d"
                                    .formatted(span, inPart, MeasuredRun.FEWEST)));
        }
        if (part.isPresent() && inPart > inLongest) {
            inLongest = inPart;
            longestPart = Optional.of(rows);
        }
        part = Optional.empty();
    }

    /** The runs, after the last row. */
    List<MeasuredRun> runs() {
        end();
        return parts.stream().map(MeasuredRunBuilder::build).toList();
    }

    /** Where each of the runs is. */
    List<Source> sources() {
        return sources;
    }

    /** The rows that follow each other without a gap and are most. */
    Source longest() {
        return longestPart.orElse(source);
    }

    /** What was done to the rows. */
    List<String> notices() {
        return notices;
    }
}
