package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.run.CellForm;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.auvsml.run.MappedColumn;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;

/** Times of runs that cannot be used. */
class BadTimesTest extends RefusedRuns {
    private static final String SORTING =
            "; sort the rows by their times, take this one out, or give rows of another run a file"
                    + " of their own or a column 'run'";

    @Test
    void aTimeIsThere() {
        refused(
                moving("y", "0").replace("0.3,3,0", ",3,0"),
                ":5: column 't': expected a number, but found ''; correct it, or take the row out");
    }

    @Test
    void timeIncreases() {
        refused(
                moving("y", "0").replace("0.3,3,0", "0.1,3,0"),
                ":5: column 't': expected a time after 0.2 s, but found '0.1'" + SORTING);
        refused(
                moving("y", "0").replace("0.3,3,0", "0.2,3,0"),
                ":5: column 't': expected a time after 0.2 s, but found '0.2'" + SORTING);
    }

    /** Another run whose number comes some rows late. */
    @Test
    void timeOfANewRunStandsBesideItsNumber() {
        StringBuilder text = new StringBuilder("t,x,run\n");
        for (int i = 0; i < 3 * ENOUGH; i++) {
            text.append(i % ENOUGH).append(',').append(i).append(i < ENOUGH + 4 ? ",7\n" : ",8\n");
        }
        refused(
                text.toString(),
                ":%d: column 't': expected a time after %s s, but found '0'; sort the rows by their times, take this one out, or give rows of another run another number in column 'run', which has '7' here as before"
                        .formatted(ENOUGH + 2, ENOUGH - 1.0));
    }

    @Test
    void timesOfDayAreNoSeconds() {
        StringBuilder text = new StringBuilder("t,x\n");
        for (int i = 0; i < ENOUGH; i++) {
            int stamp = i < 10 ? 205255 + i / 2 : 205300 + i / 2;
            text.append(stamp).append(',').append(i).append('\n');
        }
        refused(
                text.toString().replace("205305", "205300"),
                ":12: column 't': expected seconds, but 205300 follows 205259: these look like"
                        + " hours, minutes and seconds; map the column with form=\"HHMMSS\"");
    }

    @Test
    void datesAreToldTheFormThatReadsThem() {
        refused(
                moving("y", "0").replace("0.3,3,0", "2024-06-10T12:00:00.3,3,0"),
                ":5: column 't': expected a number, but found '2024-06-10T12:00:00.3'; map the"
                    + " column with form=\"ISO-8601\" (--mapping) if these are dates and times");
    }

    @Test
    void whatIsNoDateIsRefusedWhereDatesAreExpected() {
        ColumnMapping mapping =
                ColumnMapping.USUAL.with(
                        List.of(
                                new MappedColumn(
                                        "t", Optional.empty(), 1, 0, CellForm.ISO_8601, false)));
        refused(
                mapping,
                moving("y", "0").replace("0.0,0,0", "2024-06-31T12:00:00,0,0"),
                ":2: column 't': expected a date and time as 2024-06-10T12:00:00.25Z, but found"
                        + " '2024-06-31T12:00:00'; correct it, or take the row out");
    }

    @Test
    void aTimeOfDayHasSixDigits() {
        ColumnMapping mapping =
                ColumnMapping.USUAL.with(
                        List.of(
                                new MappedColumn(
                                        "t", Optional.empty(), 1, 0, CellForm.HHMMSS, false)));
        refused(
                mapping,
                moving("y", "0"),
                ":2: column 't': expected a time of day as 205259, but found '0.0'");
    }
}
