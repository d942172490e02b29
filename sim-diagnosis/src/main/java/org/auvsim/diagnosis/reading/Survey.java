package org.auvsim.diagnosis.reading;

import de.siegmar.fastcsv.reader.CsvRecord;

import org.apache.commons.math3.stat.descriptive.rank.PSquarePercentile;
import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.run.CellForm;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;

/**
 * What a first reading of a table tells of it as a whole: how many rows there are, by what clock,
 * and how often commands change.
 */
final class Survey {
    /** Times that were multiplied by 1000 are whole to so many of their last digits. */
    private static final int ROUNDING = 4;

    private final CsvTable table;
    private final Cells cells;
    private final BoundColumn time;
    private final boolean isOfStatedUnit;
    private final Midnight midnight;
    private final Optional<BoundColumn> run;
    private final List<BoundColumn> commands;
    private final String[] told;
    private final PSquarePercentile intervals = new PSquarePercentile(50);
    private long rows;
    private long line = 1;
    private long changes;
    private double last = Double.NEGATIVE_INFINITY;
    private boolean isWhole = true;
    private long repeats;
    private Optional<DocumentException> repeat = Optional.empty();
    private long stamps;

    /** Of the run that a row is of, and how many rows have the last of them. */
    private long stampsOfRun;

    private long ofStamp;

    /** Stamps that are neither the first nor the last of their run, and their rows. */
    private long wholeStamps;

    private long ofWholeStamps;
    private String ofRun = "";
    private OptionalLong afterMidnight = OptionalLong.empty();

    private Survey(CsvTable table, Layout layout) {
        this.table = table;
        this.cells = new Cells(table);
        this.time = layout.time();
        this.isOfStatedUnit = layout.statesUnitOfTime();
        this.midnight = new Midnight(time);
        this.run = layout.of(Slots.RUN);
        this.commands = layout.columns().stream().filter(c -> c.slot() >= Slots.COMMANDS).toList();
        this.told = new String[commands.size()];
        Arrays.fill(told, "");
    }

    /**
     * Reads all of a table.
     *
     * @throws DocumentException if its times do not increase
     */
    static Survey of(CsvTable table, Layout layout) throws DocumentException {
        Survey survey = new Survey(table, layout);
        for (Optional<CsvRecord> row = table.row(); row.isPresent(); row = table.row()) {
            survey.take(row.get());
        }
        if (!survey.isWhole && survey.repeat.isPresent()) {
            throw survey.repeat.get();
        }
        return survey;
    }

    private void take(CsvRecord row) throws DocumentException {
        line = row.getStartingLineNumber();
        double written = cells.number(row, time);
        if (run.isPresent() && !Cells.text(row, run.get()).equals(ofRun)) {
            ofRun = Cells.text(row, run.get());
            last = Double.NEGATIVE_INFINITY;
            stampsOfRun = 0;
            midnight.restart();
            Arrays.fill(told, "");
        }
        if (afterMidnight.isEmpty() && midnight.isPassedAt(written)) {
            afterMidnight = OptionalLong.of(line);
        }
        double now = midnight.countedOn(written);
        isWhole &= Math.abs(now - Math.rint(now)) <= ROUNDING * Math.ulp(now);
        if (now < last) {
            throw notLater(row);
        } else if (now == last) {
            repeats++;
            repeat = repeat.isEmpty() ? Optional.of(notLater(row)) : repeat;
        } else if (Double.isFinite(last)) {
            requireSeconds(row, now);
            intervals.increment(now - last);
        }
        count(now);
        last = now;
        rows++;
        changes += isToldOtherwise(row) ? 1 : 0;
    }

    private void count(double now) {
        if (now == last) {
            ofStamp++;
            return;
        }
        if (stampsOfRun > 1) {
            wholeStamps++;
            ofWholeStamps += ofStamp;
        }
        stamps++;
        stampsOfRun++;
        ofStamp = 1;
    }

    private DocumentException notLater(CsvRecord row) {
        return cells.expected(
                row,
                time,
                "a time after %s s".formatted(last),
                "sort the rows by their times, take this one out, or give rows of another run "
                        + run.map(this::ofItsOwn).orElse("a file of their own or a column 'run'"));
    }

    private String ofItsOwn(BoundColumn column) {
        return "another number in column '%s', which has '%s' here as before"
                .formatted(column.name(), ofRun);
    }

    /** Refuses 205259, 205300: a clock's digits are no seconds. */
    private void requireSeconds(CsvRecord row, double now) throws DocumentException {
        if (time.form() == CellForm.NUMBER
                && repeats > 0
                && isWhole
                && now - last == 41
                && last % 100 == 59) {
            throw table.at(
                    row.getStartingLineNumber(),
                    time.name(),
                    String.format(
                            Locale.ROOT,
                            "expected seconds, but %.0f follows %.0f: these look like hours,"
                                    + " minutes and seconds; map the column with form=\"HHMMSS\"",
                            now,
                            last));
        }
    }

    private boolean isToldOtherwise(CsvRecord row) {
        boolean differs = false;
        for (int i = 0; i < told.length; i++) {
            String text = Cells.text(row, commands.get(i));
            if (!text.isEmpty() && !text.equals(told[i])) {
                told[i] = text;
                differs = true;
            }
        }
        return differs;
    }

    long rows() {
        return rows;
    }

    /** The last row, as an editor counts it; that of the header if there is no other. */
    long lastLine() {
        return line;
    }

    /** The column that has the time. */
    BoundColumn time() {
        return time;
    }

    /** The first row, as an editor counts it, whose time of day is of the next day. */
    OptionalLong afterMidnight() {
        return afterMidnight;
    }

    /** How much there is. */
    Extent extent() {
        return new Extent(rows, changes, interval());
    }

    /** Whether times are whole seconds with several rows each. */
    boolean hasWholeSeconds() {
        return repeats > 0;
    }

    /** The usual time between two rows (s). */
    double interval() {
        return hasWholeSeconds() ? 1 / rate() : intervals.getResult();
    }

    /**
     * Whether times are whole numbers that are far apart, as those in ms would be, and nobody said
     * in which unit they are.
     */
    boolean looksLikeMilliseconds() {
        return !isOfStatedUnit && isWhole && !hasWholeSeconds() && rows > 2 && interval() >= 5;
    }

    /** Rows a second, of the seconds that are whole. */
    private double rate() {
        return wholeStamps > 0 ? (double) ofWholeStamps / wholeStamps : (double) rows / stamps;
    }
}
