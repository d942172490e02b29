package org.auvsim.diagnosis.reading;

import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.auvsml.run.MappedColumn;
import org.auvsim.auvsml.run.MeasuredAxes;
import org.auvsim.auvsml.run.ShakingColumns;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.Optional;

/** Columns of runs that cannot be used, by their names and what they mean. */
class BadColumnsTest extends RefusedRuns {
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

    @Test
    void aTimeIsNeeded() {
        refused(
                moving("y", "0").replace("t,x", "time,x").replace("time", "depth"),
                ":1: column 't': the header has no column with the time in s, only depth, x, y;"
                        + " rename the one that has it (--rename COLUMN=t)");
    }

    @Test
    void aMappedColumnMustBeThere() {
        refused(
                ColumnMapping.USUAL.with(List.of(MappedColumn.renamed("hight", "z"))),
                moving("height", "0"),
                ":1: column 'hight': it is to be renamed to 'z', but the header has none of this"
                        + " name; did you mean 'height'?");
    }

    /** It would be told that the column it stands for may be meant. */
    @Test
    void aRenamingOfNothingIsLeftOutWhereItsNameIsThere() {
        refused(
                ColumnMapping.USUAL.with(List.of(MappedColumn.renamed("yy", "y"))),
                moving("y", "0"),
                ":1: column 'yy': it is to be renamed to 'y', but the header has none of this name;"
                        + " a column has that name already: leave this renaming out");
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
}
