package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.auvsml.run.MeasuredAxes;
import org.auvsim.diagnosis.result.Verdict;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.IntFunction;

/** What may be right but looks wrong is told, with its place, and read as it is. */
class SuspicionsTest {
    private static final int ENOUGH = 20;

    @TempDir private Path folder;

    private String at(String place) {
        return folder.resolve("run.csv") + place;
    }

    /** A fin that is not told may be fixed; where nothing drives, what was told is missing. */
    @ParameterizedTest
    @CsvSource({
        "'x,main,rudder', 0, false",
        "'x,main', 1, false",
        "'x,rudder', 1, true",
        "x, 1, true"
    })
    void commandsThatAreMissingAreTold(String header, int notices, boolean isDoubtful)
            throws Exception {
        String zeros = ",0".repeat(header.split(",", -1).length - 1);

        RunFile file = Rov.read(folder, ColumnMapping.USUAL, Rov.rows(header, 60, i -> i + zeros));

        assertThat(file.notices())
                .filteredOn(
                        notice ->
                                notice.contains("keep the scenario's values")
                                        || notice.contains("level of the propulsor")
                                        || notice.contains("angle of the fin"))
                .hasSize(notices);
        assertThat(file.doubt() == Doubt.LASTING).isEqualTo(isDoubtful);
    }

    @Test
    void millimetresAreSuspected() throws Exception {
        String text =
                Rov.rows(
                        "x,y,z,main,rudder",
                        60,
                        i -> "0," + 1000 * 0.5 * 20 / 30 * 0.01 * i * i + ",0,1,0");

        assertThat(Rov.read(folder, ColumnMapping.USUAL, text).notices())
                .anyMatch(notice -> notice.contains("1000 times less far"))
                .anyMatch(notice -> notice.contains("are these positions in mm"));
    }

    @Test
    void metresAreNotSuspected() throws Exception {
        String text =
                Rov.rows(
                        "x,y,z,main,rudder",
                        60,
                        i -> "0," + 0.5 * 20 / 30 * 0.01 * i * i + ",0,1,0");

        assertThat(Rov.read(folder, ColumnMapping.USUAL, text).notices()).isEmpty();
    }

    /**
     * Told to do next to nothing at first, it is pushed by something unknown, 1000 times as much;
     * then it goes as far as the model, the other way.
     */
    @Test
    void aPartThatHappensToBendAlikeIsNotOfAnotherUnitWhereTheRestIsAsLong() throws Exception {
        String text =
                Rov.rows(
                        "x,y,z,main,rudder,push",
                        90,
                        i -> {
                            double pushed = 0.5 * 20 / 30 * 0.01;
                            double y =
                                    i < 30
                                            ? pushed * i * i
                                            : pushed
                                                    * (900
                                                            + 60 * (i - 30)
                                                            - 1.2 * (i - 30) * (i - 30));
                            return "0," + y + ",0," + (i < 30 ? 0.001 : 1) + ",0,0";
                        });

        assertThat(Rov.read(folder, ColumnMapping.USUAL, text).notices()).isEmpty();
    }

    /** A thousandth of the model's way, with two kinks in it; between these it bends otherwise. */
    @ParameterizedTest
    @CsvSource({"-1, true", "0.3, false"})
    void aWayThatBendsAlikeAsAWholeAloneIsNotOfAnotherUnit(double bend, boolean isSuspected)
            throws Exception {
        String text =
                Rov.rows(
                        "x,y,z,main,rudder",
                        91,
                        i -> {
                            int kink = i / 30 * 30;
                            double of = i - kink;
                            double along = kink * kink + of * (2 * kink + 30);
                            double told = 1e-5 / 30 * 0.5 * (along + bend * of * (30 - of));
                            return "0," + 3 * told + "," + 4 * told + ",0,0";
                        });

        assertThat(Rov.read(folder, ColumnMapping.USUAL, text).notices())
                .filteredOn(notice -> notice.contains("are these positions in km?"))
                .hasSize(isSuspected ? 1 : 0);
    }

    @ParameterizedTest
    @CsvSource({"ENU, ENU, 0", "NED, NED, 0", "NED, ENU, 1", "ENU, NED, 1"})
    void otherAxesAreSuspectedByHowTheModelMoves(
            MeasuredAxes told, MeasuredAxes readAs, int suspicions) throws Exception {
        RunFile file = Rov.read(folder, ColumnMapping.USUAL.in(readAs), sinking(told, 5));

        assertThat(file.notices())
                .filteredOn(notice -> notice.contains("are these the axes?"))
                .hasSize(suspicions)
                .allMatch(
                        notice -> notice.startsWith(at(": the model moves as this does if x is")));
    }

    /** How far a unit force has pushed it by a row (m). */
    private static double pushed(int row) {
        return 0.5 / 30 * 0.01 * row * row;
    }

    /** By noise that is most of how the path bends in a third of the run. */
    @ParameterizedTest
    @CsvSource({"1, 0", "-1, 1"})
    void heightsThatAreDepthsAreSeenThroughNoise(double sign, int suspicions) throws Exception {
        Random random = new Random(3);
        String text =
                Rov.rows(
                        "x,y,z,main,rudder",
                        60,
                        i -> {
                            double along = pushed(i);
                            double left = 3 * along + 0.012 * random.nextGaussian();
                            double up = sign * 4 * along + 0.012 * random.nextGaussian();
                            return "0," + left + "," + up + ",0,0";
                        });

        assertThat(Rov.read(folder, ColumnMapping.USUAL, text).notices())
                .filteredOn(notice -> notice.contains("z were positive the other way"))
                .hasSize(suspicions);
    }

    /** A push to the left and up that is told as one along other axes. */
    @ParameterizedTest
    @CsvSource({
        "0, 3, 4, ''",
        "3, 0, 4, x and y were swapped",
        "0, 4, 3, ''",
        "4, 3, 0, x and z were swapped",
        "0, -3, 4, y were positive the other way",
        "0, 3, -4, z were positive the other way"
    })
    void mixedColumnsAreSuspectedByHowTheModelMoves(double x, double y, double z, String mixed)
            throws Exception {
        String text =
                Rov.rows(
                        "x,y,z,main,rudder",
                        60,
                        i -> {
                            double along = pushed(i);
                            return x * along + "," + y * along + "," + z * along + ",0,0";
                        });

        assertThat(Rov.read(folder, ColumnMapping.USUAL, text).notices())
                .filteredOn(notice -> notice.contains("the model moves as this does"))
                .hasSize(mixed.isEmpty() ? 0 : 1)
                .allMatch(notice -> notice.startsWith(at(": the model moves as this does if ")))
                .allMatch(notice -> notice.contains(mixed + ": "));
    }

    /** All files have the same axes: what one of them alone speaks for may be a missing force. */
    @ParameterizedTest
    @CsvSource({"1, 0, NONE", "3, 1, UNTIL_EXPLAINED", "3, 2, LASTING", "1, 1, LASTING"})
    void otherAxesAreThoseOfMostFiles(int files, int others, Doubt doubt) throws Exception {
        List<Path> runs = new ArrayList<>();
        for (int i = 0; i < files; i++) {
            runs.add(
                    Rov.write(
                            folder.resolve("run" + i + ".csv"),
                            sinking(i < others ? MeasuredAxes.NED : MeasuredAxes.ENU, 5 + i)));
        }
        RunFiles read = RunFiles.read(Rov.reader(ColumnMapping.USUAL), runs, List.of());

        assertThat(read.doubt()).isEqualTo(doubt);
        assertThat(read.noticesAfter(Verdict.EXPLAINED, Map.of()))
                .filteredOn(notice -> notice.contains("the model moves as this does"))
                .hasSize(others)
                .allMatch(
                        notice ->
                                notice.contains("are these the axes?") == (doubt == Doubt.LASTING));
    }

    /** A push to the left and up for 6 s; the Rov has one of 5 N all the time. */
    private static String sinking(MeasuredAxes axes, double push) {
        return Rov.rows(
                "x,y,z,main,rudder",
                60,
                i -> {
                    double along = push / 10 / 30 * 0.01 * i * i;
                    double y = 3 * along;
                    double z = 4 * along;
                    return axes == MeasuredAxes.NED
                            ? y + ",0," + -z + ",0,0"
                            : "0," + y + "," + z + ",0,0";
                });
    }

    @Test
    void velocitiesInAnotherUnitThanPositionsAreSuspected() throws Exception {
        String text = Rov.rows("x,y,z,vx,vy,vz", ENOUGH, i -> i + ",0,0,10000,0,0");

        assertThat(Rov.read(folder, ColumnMapping.USUAL, text).notices())
                .anyMatch(
                        notice ->
                                notice.equals(
                                        at(":2: columns 'x', 'vx': ")
                                                + "positions go 0.001 times as far as velocities"
                                                + " say: is one of them in another unit?"));
    }

    @Test
    void millisecondsAreSuspected() throws Exception {
        requireMilliseconds(i -> Integer.toString(50 * i));
    }

    /** 0.15 s are 150.00000000000003 ms. */
    @Test
    void soTheyAreWhereRoundingShows() throws Exception {
        requireMilliseconds(i -> Double.toString(0.05 * i * 1000));
    }

    private void requireMilliseconds(IntFunction<String> time) throws Exception {
        StringBuilder text = new StringBuilder("t,yaw\n");
        for (int i = 0; i < ENOUGH; i++) {
            text.append(time.apply(i)).append(',').append(0.1 * i).append('\n');
        }

        assertThat(Rov.read(folder, ColumnMapping.USUAL, text.toString()).notices())
                .contains(
                        at(":2: column 't': ")
                                + "rows are 50 s apart by whole numbers: are these milliseconds? If"
                                + " so, map 't' with a scale of 0.001 (--mapping)");
    }

    @Test
    void degreesAreSuspected() throws Exception {
        assertThat(
                        Rov.read(
                                        folder,
                                        ColumnMapping.USUAL,
                                        Rov.rows("yaw,r", ENOUGH, i -> 9 * i + "," + 3 * i))
                                .notices())
                .contains(
                        at(":21: column 'yaw': ")
                                + "angles go up to 171 rad: are they in degrees (--degrees, if all"
                                + " files are)? Of a heading that counts its turns, take whole"
                                + " turns away",
                        at(":2: column 'r': ")
                                + "p, q, r differ by up to 57 rad/s: are they in degrees"
                                + " (--degrees, if all files are)?");
    }

    /** A vehicle goes round and round: its heading counts its turns. */
    @Test
    void anglesThatAModelExplainsWereNoDegrees() throws Exception {
        String text = Rov.rows("yaw,main,rudder", ENOUGH, i -> 3 * i + ",0.5,0");
        RunFile file = Rov.read(folder, ColumnMapping.USUAL, text);

        assertThat(file.notices()).anyMatch(notice -> notice.contains("are they in degrees"));
        assertThat(file.doubt()).isEqualTo(Doubt.UNTIL_EXPLAINED);
        assertThat(file.doubt().isOpen(Verdict.EXPLAINED, Map.of())).isFalse();
        assertThat(file.doubt().isOpen(Verdict.NONE, Map.of())).isFalse();
        assertThat(file.doubt().isOpen(Verdict.UNEXPLAINED, Map.of())).isTrue();
        assertThat(file.doubt().and(Doubt.LASTING).isOpen(Verdict.NONE, Map.of())).isTrue();
    }

    @Test
    void whatIsReadAsDegreesIsNotSuspectedToBeSo() throws Exception {
        ColumnMapping degrees = ColumnMapping.USUAL.inDegrees();

        assertThat(
                        Rov.read(
                                        folder,
                                        degrees,
                                        Rov.rows("yaw,r", ENOUGH, i -> 9 * i + "," + 300 * i))
                                .notices())
                .noneMatch(notice -> notice.contains("--degrees"));
    }
}
