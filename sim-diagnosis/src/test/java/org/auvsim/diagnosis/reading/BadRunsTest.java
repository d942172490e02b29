package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.run.CellForm;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.auvsml.run.Limit;
import org.auvsim.auvsml.run.MappedColumn;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Files, rows and numbers of runs that cannot be used. */
class BadRunsTest extends RefusedRuns {
    @Test
    void theDocumentOfARunIsNoRun() {
        refused(
                "<?xml version=\"1.0\"?>\n<run role=\"FIT\"/>\n",
                ":1: is XML, and no run: expected CSV, a header line with the columns' names and"
                    + " rows below it; a run's document is read automatically; give the run's CSV"
                    + " file instead");
    }

    @ParameterizedTest
    @ValueSource(chars = {',', ';'})
    void decimalCommasAreSuspected(char separator) {
        String text = moving("y", "0").replace(',', separator).replace('.', ',');
        refused(
                text,
                separator == ','
                        ? ":2: expected 3 fields as in the header, but found 4: do its numbers have"
                                + " decimal commas? Write 1.5, not 1,5"
                        : ":2: column 't': expected a number, but found '0,0': is that a decimal"
                                + " comma? Export the file with decimal points, and commas between"
                                + " columns");
    }

    @Test
    void aFolderIsNoRun() {
        assertThatThrownBy(() -> Rov.reader(ColumnMapping.USUAL).read(folder))
                .isInstanceOf(DocumentException.class)
                .hasMessage(folder + " is a folder; expected a file, name one in it");
    }

    @Test
    void somethingMustHaveBeenMeasured() throws IOException {
        assertThatThrownBy(
                        () ->
                                Rov.read(
                                        folder,
                                        ColumnMapping.USUAL,
                                        Rov.rows("main", ENOUGH, i -> "0")))
                .hasMessageContaining("run.csv: the header has nothing that was measured");
    }

    @Test
    void aQuaternionHasLengthOne() {
        refused(
                moving("qw,qx,qy,qz", "0.9,0,0,0"),
                ":2: column 'qw': expected a quaternion of length 1 (within 0.01), but its length"
                        + " is 0.9; are its columns in order and unscaled?");
    }

    @ParameterizedTest
    @CsvSource({"far,far", "1e999,1e999", "inf,inf", "1.5f,1.5f", "3d,3d", "0x1p3,0x1p3"})
    void aNumberIsFinite(String cell, String told) {
        String text = moving("y", "0").replace("0.3,3,0", "0.3,3," + cell);
        refused(text, ":5: column 'y': expected a number, but found '" + told + "'" + MENDING);
    }

    private static ColumnMapping ending(String column) {
        return ColumnMapping.USUAL.with(
                List.of(
                        new MappedColumn(
                                column,
                                Optional.empty(),
                                1,
                                0,
                                CellForm.NUMBER,
                                false,
                                List.of(),
                                Optional.of(new Limit(Optional.of(9.0), Optional.empty())))));
    }

    @Test
    void aColumnByWhichARunEndsHasNumbers() {
        refused(
                ending("press"),
                moving("press", "0").replace("0.3,3,0", "0.3,3,low"),
                ":5: column 'press': expected a number, but found 'low'" + MENDING);
        refused(
                ending("pres"),
                moving("press", "0"),
                ":1: column 'pres': the mapping names this column, but the header has none of this"
                        + " name; did you mean 'press'?");
    }

    /** One that is left out may be missing, but not if runs end by it. */
    @Test
    void aColumnThatIsLeftOutMayBeMissing() throws IOException, DocumentException {
        ColumnMapping leavingOut = ColumnMapping.USUAL.with(List.of(MappedColumn.ignored("pres")));
        assertThat(Rov.read(folder, leavingOut, moving("y", "0")).runs()).hasSize(1);

        MappedColumn ending = ending("pres").column().getFirst();
        refused(
                ColumnMapping.USUAL.with(
                        List.of(
                                new MappedColumn(
                                        "pres",
                                        Optional.empty(),
                                        1,
                                        0,
                                        CellForm.NUMBER,
                                        true,
                                        List.of(),
                                        ending.runEnds()))),
                moving("press", "0"),
                ":1: column 'pres': the mapping names this column, but the header has none of this"
                        + " name; did you mean 'press'?");
    }

    @Test
    void aRunIsLongEnoughBeforeItEnds() {
        refused(
                ending("x"),
                moving("y", "0"),
                ":2: no 16 rows follow each other without a long gap, before a column is beyond its"
                        + " limit; a shorter run tells nothing: give a longer one");
    }

    @Test
    void aRowHasAFieldForEachColumn() {
        refused(
                moving("y", "0").replace("0.3,3,0", "0.3,3"),
                ":5: expected 3 fields as in the header, but found 2; complete the row, or take it"
                        + " out if the file was cut off");
        refused(
                moving("y", "0").replace("0.3,3,0", "0.3,3.5,0,5"),
                ":5: expected 3 fields as in the header, but found 4; is there a comma in a number,"
                        + " or a column without a name?");
    }

    @Test
    void aRunIsLongEnough() {
        refused(
                Rov.rows("x", 15, i -> "" + i),
                ":16: expected at least 16 rows, but found 15; a shorter run tells nothing: give a"
                        + " longer one");
    }

    @Test
    void betweenGapsARunIsLongEnough() {
        String text = Rov.rows("x", 25, i -> "" + i).replaceAll("(?m)^1\\.(\\d),", "61.$1,");
        String gaps = text.replaceAll("(?m)^2\\.(\\d),", "99.$1,");
        refused(
                gaps,
                ":2: no 16 rows follow each other without a long gap; a shorter run tells nothing:"
                        + " give a longer one");
    }

    @Test
    void anEmptyFileIsNoRun() {
        refused("", " is empty: expected a header line with the columns' names and rows below it");
    }

    @Test
    void aFileThatIsNotThereIsNoRun() {
        Path missing = folder.resolve("missing.csv");
        assertThatThrownBy(() -> Rov.reader(ColumnMapping.USUAL).read(missing))
                .isInstanceOf(DocumentException.class)
                .hasMessage(missing + ": there is no such file");
    }

    @Test
    void aScenarioIsNoRun() throws IOException {
        Path scenario = Rov.write(folder.resolve("model.xml"), Rov.SCENARIO);
        assertThatThrownBy(() -> Rov.reader(ColumnMapping.USUAL).read(scenario))
                .hasMessage(
                        scenario + " is a scenario; expected a measured run, CSV or a recording");
    }

    @Test
    void aCommandIsWhatItsActuatorCanDo() {
        refused(
                moving("main", "1500"),
                ":2: column 'main': the level of propulsor 'main' must be -1 to 1, but is 1500.0"
                        + " (found '1500'); map the column with a scale and an offset if it has"
                        + " another unit");
    }

    @Test
    void aCommandIsThereFromTheBeginning() {
        refused(
                moving("main", ""),
                ":2: column 'main': expected what is commanded where the run begins, but found '';"
                        + " fill in what held before, or 0");
    }

    /** What the run before was told last says nothing of it. */
    @Test
    void aCommandIsThereFromTheBeginningOfEachRun() {
        refused(
                Rov.rows(
                        "run,x,main",
                        2 * ENOUGH,
                        i -> (i < ENOUGH ? 1 : 2) + "," + i + "," + (i == ENOUGH ? "" : "0.5")),
                ":%d: column 'main': expected what is commanded where the run begins, but found ''; fill in what held before, or 0"
                        .formatted(ENOUGH + 2));
    }

    @Test
    void aDeviationIsAboveZero() {
        refused(
                moving("sd_x", "0"),
                ":2: column 'sd_x': expected a standard deviation above 0, but found '0'; leave the"
                        + " cell empty where none is known, or ignore the column (--ignore sd_x)");
    }

    @Test
    void nothingIsLearntFromARunThatNeverChanges() {
        refused(
                Rov.rows("x,yaw,main", ENOUGH, i -> "1,2,0." + i % 2),
                ":2: columns 'x', 'yaw': every measured number of run 'run' is the same from its"
                        + " first row to its last; nothing can be learnt from it: leave it out, or"
                        + " look at what wrote it");
    }

    @Test
    void norFromOneWithoutAnyNumber() {
        refused(
                Rov.rows("x,yaw,main", ENOUGH, i -> "nan,,0." + i % 2),
                ":2: columns 'x', 'yaw': run 'run' has no measured number in any row; expected"
                        + " some: leave the run out, or look at what wrote it");
    }

    /** Angles that are rounded when they become quaternions still do not change. */
    @Test
    void norFromOneOfWhichAllAnglesAreTold() {
        refused(
                Rov.rows("x,roll,pitch,yaw,main", ENOUGH, i -> "1,1,1,1,0." + i % 2),
                ":2: columns 'x', 'roll', 'pitch', 'yaw': every measured number of run 'run' is the"
                    + " same from its first row to its last; nothing can be learnt from it: leave"
                    + " it out, or look at what wrote it");
    }
}
