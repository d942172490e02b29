package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.run.CellForm;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.auvsml.run.Limit;
import org.auvsim.auvsml.run.MappedColumn;
import org.auvsim.auvsml.run.MeasuredAxes;
import org.auvsim.auvsml.run.ShakingColumns;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Each sentence has the file, the row as an editor counts it, and the column. */
class BadRunsTest {
    private static final int ENOUGH = 20;
    private static final String MENDING =
            "; correct it, or leave the cell empty if nothing was measured";
    private static final String SORTING =
            "; sort the rows by their times, take this one out, or give rows of another run a file"
                    + " of their own or a column 'run'";

    @TempDir private Path folder;

    private void refused(String text, String sentence) {
        refused(ColumnMapping.USUAL, text, sentence);
    }

    private void refused(ColumnMapping mapping, String text, String sentence) {
        assertThatThrownBy(() -> Rov.read(folder, mapping, text))
                .isInstanceOf(DocumentException.class)
                .hasMessage(folder.resolve("run.csv") + sentence);
    }

    private static String moving(String header, String cells) {
        return Rov.rows("x," + header, ENOUGH, i -> i + "," + cells);
    }

    @Test
    void anUnknownColumnHasItsNearestKnownNames() {
        refused(
                moving("yaww", "0"),
                ":1: column 'yaww': unknown name 'yaww'; did you mean 'yaw'?"
                        + " Rename it (--rename yaww=yaw), ignore it (--ignore yaww), or give a"
                        + " force or actuator of 'Rov' that name");
    }

    @Test
    void aHeaderHasNames() {
        refused(
                "0.0,1,0\n0.1,2,0\n",
                ":1: has numbers where a header line was expected: write one with the columns'"
                        + " names above the rows, as t,x,y,z");
    }

    @ParameterizedTest
    @ValueSource(strings = {"t|x|y", "t x y", "# a dive"})
    void columnsAreSeparatedByCommas(String header) {
        refused(
                header + "\n0.0,1,0\n",
                ":1: is one column, '%s': expected a header line with commas, semicolons or tabs between the columns' names; separate all rows so, and take comments out"
                        .formatted(header));
    }

    @Test
    void theDocumentOfARunIsNoRun() {
        refused(
                "<?xml version=\"1.0\"?>\n<run role=\"FIT\"/>\n",
                ":1: is XML, and no run: expected CSV, a header line with the columns' names and"
                    + " rows below it; a run's document is read automatically; give the run's CSV"
                    + " file instead");
    }

    @ParameterizedTest
    @ValueSource(strings = {"\u0001\u0002,x\n1,2\n", "LONG"})
    void whatHasNoNamesInItsFirstLineIsNoCsv(String text) {
        refused(
                text.replace("LONG", "0123456789".repeat(500)),
                ":1: is no CSV: expected a header line with the columns' names, with commas between"
                        + " them; give the file with the run's rows");
    }

    /** Two neighbours that changed places are one slip, also in a name of four letters. */
    @Test
    void lettersThatChangedPlacesAreASlip() {
        refused(
                moving("mian", "0"),
                ":1: column 'mian': unknown name 'mian'; did you mean 'main'?"
                        + " Rename it (--rename mian=main), ignore it (--ignore mian), or give a"
                        + " force or actuator of 'Rov' that name");
    }

    @Test
    void unknownColumnsAreToldAllAtOnceWithWhatMendsThem() {
        refused(
                Rov.rows("X,Yaw_deg,y_m,MAIN,volt", ENOUGH, i -> i + ",0,0,0,12")
                        .replace("t,", "T,"),
                ":1: columns 'T', 'X', 'Yaw_deg', 'y_m', 'MAIN', 'volt': unknown names; rename what"
                    + " has a usual name but for its spelling (--rename T=t,X=x,y_m=y,MAIN=main);"
                    + " map what is in another unit (--mapping FILE with <column-mapping><column"
                    + " name=\"Yaw_deg\" means=\"yaw\""
                    + " scale=\"0.017453292519943295\"/></column-mapping>); ignore the others"
                    + " (--ignore volt), or rename what has a usual quantity (--rename"
                    + " volt=USUAL)");
    }

    /** Neither a second x nor two of them are meant. */
    @Test
    void aQuantityIsMeantByOneColumnOnly() {
        refused(
                moving("X,Y,y_m", "0,0,0"),
                ":1: columns 'X', 'Y', 'y_m': unknown names; rename what has a usual name but for"
                    + " its spelling (--rename Y=y); ignore the others (--ignore X,y_m), or rename"
                    + " what has a usual quantity (--rename X=USUAL)");
    }

    @ParameterizedTest
    @CsvSource({
        "x_mm, x, 0.001",
        "t [ms], t, 0.001",
        "time_ms, t, 0.001",
        "u (cm/s), u, 0.01",
        "p_dps, p, 0.017453292519943295",
        "sd_yaw.deg, sd_yaw, 0.017453292519943295"
    })
    void aUnitBehindAUsualNameIsMapped(String name, String usual, String scale) {
        refused(
                Rov.rows("vertical", ENOUGH, String::valueOf)
                        .replace("t,vertical", (usual.equals("t") ? "y," : "t,") + name),
                ":1: column '%1$s': unknown name '%1$s'; did you mean '%2$s' in another unit? Map it (--mapping FILE with <column-mapping><column name=\"%1$s\" means=\"%2$s\" scale=\"%3$s\"/></column-mapping>), ignore it (--ignore %4$s), or give a force or actuator of 'Rov' that name"
                        .formatted(
                                name, usual, scale, name.contains(" ") ? '"' + name + '"' : name));
    }

    /** Degrees need no factor where all angles are in degrees. */
    @Test
    void aUnitThatIsAsReadNeedsANewNameOnly() {
        refused(
                moving("y_m", "0"),
                ":1: column 'y_m': unknown name 'y_m'; did you mean 'y'? Rename it (--rename"
                        + " y_m=y), ignore it (--ignore y_m), or give a force or actuator of 'Rov'"
                        + " that name");
        refused(
                ColumnMapping.USUAL.inDegrees(),
                moving("yaw_deg", "0"),
                ":1: column 'yaw_deg': unknown name 'yaw_deg'; did you mean 'yaw'? Rename it"
                        + " (--rename yaw_deg=yaw), ignore it (--ignore yaw_deg), or give a force"
                        + " or actuator of 'Rov' that name");
    }

    @Test
    void whatAColumnIsRenamedToMayBeASlipToo() {
        refused(
                ColumnMapping.USUAL.with(List.of(MappedColumn.renamed("pwm 1", "mian"))),
                moving("pwm 1", "0"),
                ":1: column 'pwm 1': it is said to mean 'mian', which is an unknown name; did you"
                        + " mean 'main'? Correct it where that is said (means=\"main\" in the"
                        + " mapping, or --rename), ignore it (--ignore \"pwm 1\"), or give a"
                        + " force or actuator of 'Rov' that name");
    }

    /** Options take what is between commas for a name each. */
    @Test
    void aNameThatNoOptionCanTellIsToldInAMapping() {
        refused(
                moving("\"a,b\"", "0"),
                ":1: column 'a,b': unknown name 'a,b'; rename it to the usual name of its"
                        + " quantity (in a --mapping file: the name contains a character that is"
                        + " special in --rename), ignore it (in a --mapping file: a name contains a"
                        + " character that is special in --ignore), or give a"
                        + " force or actuator of 'Rov' that name");
    }

    @ParameterizedTest
    @ValueSource(strings = {"temperature", "pwm1", "q8"})
    void aNameThatIsNearToNoneHasNone(String name) {
        refused(
                moving(name, "0"),
                ":1: column '%s': unknown name '%s'; rename it to the usual name of its quantity"
                                .formatted(name, name)
                        + " (--rename %s=USUAL), ignore it (--ignore %s), or give a force or"
                                .formatted(name, name)
                        + " actuator of 'Rov' that name");
    }

    @Test
    void aTimeByAnotherNameHasTheUsualOne() {
        refused(
                Rov.rows("x", ENOUGH, String::valueOf).replace("t,x", "time_s,x"),
                ":1: column 'time_s': unknown name 'time_s'; rename it to the usual name of its"
                    + " quantity (--rename time_s=t), ignore it (--ignore time_s), or give a force"
                    + " or actuator of 'Rov' that name");
    }

    @Test
    void capitalsAreASlip() {
        refused(
                moving("Yaw", "0"),
                ":1: column 'Yaw': unknown name 'Yaw'; did you mean 'yaw'? Rename"
                        + " it (--rename Yaw=yaw), ignore it (--ignore Yaw), or give a force or"
                        + " actuator of 'Rov' that name");
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
    void aTimeIsNeeded() {
        refused(
                moving("y", "0").replace("t,x", "time,x").replace("time", "depth"),
                ":1: column 't': the header has no column with the time in s, only depth, x, y;"
                        + " rename the one that has it (--rename COLUMN=t)");
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
    void aMappedColumnMustBeThere() {
        refused(
                ColumnMapping.USUAL.with(List.of(MappedColumn.renamed("hight", "z"))),
                moving("height", "0"),
                ":1: column 'hight': it is to be renamed to 'z', but the header has none of this"
                        + " name; did you mean 'height'?");
    }

    @Test
    void aNameStandsOnceInAHeader() {
        refused(
                moving("x", "0"),
                ":1: column 'x': this name is in the header twice; give each column its own name");
    }

    @Test
    void nothingIsStatedTwice() {
        refused(
                moving("z,depth", "0,0"),
                ":1: column 'depth': column 'z' already provides this quantity; ignore one of the"
                        + " two (--ignore depth)");
        refused(
                moving("qw,qx,qy,qz,yaw", "1,0,0,0,0"),
                ":1: column 'yaw': the orientation is there as a quaternion already; ignore one of"
                        + " the two (--ignore yaw)");
        refused(
                moving("vx,v", "0,0"),
                ":1: column 'vx': vx, vy, vz are in the world's axes and u, v, w in the body's;"
                        + " ignore those of one kind (--ignore v)");
    }

    @Test
    void aQuaternionIsWhole() {
        refused(
                moving("qw,qz", "1,0"),
                ":1: column 'qw': a quaternion needs all of qw, qx, qy and qz, but there is no qx"
                    + " and no qy: name the columns that have them (--rename COLUMN=qx), or ignore"
                    + " what there is (--ignore qw,qz)");
        refused(
                moving("qw,qx,qy,qz", "1,,0,0"),
                ":2: column 'qw': expected four numbers of the quaternion, or none, but some are"
                        + " missing");
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

    private static ColumnMapping shaking(String acceleration, String rate) {
        return new ColumnMapping(
                MeasuredAxes.ENU,
                false,
                false,
                Optional.empty(),
                Optional.of(new ShakingColumns(acceleration, rate)),
                List.of());
    }

    @Test
    void columnsThatTellOfShakingHaveNumbers() {
        refused(
                shaking("ax", "wy"),
                moving("ax,wy", "0,1").replace("0.3,3,0,1", "0.3,3,0,none"),
                ":5: column 'wy': expected a number, but found 'none'" + MENDING);
        refused(
                shaking("ay", "wy"),
                moving("ax,wy", "0,1"),
                ":1: column 'ay': the mapping reads shaking from this column, but the header has"
                        + " none of this name; there are t, x, ax, wy");
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
