package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.diagnosis.result.Verdict;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Random;

/** A heading and its rate, told in units and axes of their own. */
class AnglesAndRatesTest {
    private static final int ROWS = 300;

    @TempDir private Path folder;

    /** Turns to and fro, and on the whole round several times. */
    private static double heading(double t) {
        return 0.6 * t + 2 * Math.sin(0.3 * t);
    }

    private static double rate(double t) {
        return 0.6 + 0.6 * Math.cos(0.3 * t);
    }

    private List<String> notices(double angle, double rate, boolean isWrapped) throws Exception {
        return notices(read(angle, rate, isWrapped));
    }

    private static List<String> notices(RunFile file) {
        return file.notices().stream()
                .filter(said -> said.contains("turn") || said.contains("degrees"))
                .toList();
    }

    /** So many units a radian; wrapped to half a turn either way or not. */
    private RunFile read(double angle, double rate, boolean isWrapped) throws Exception {
        Random random = new Random(3);
        String text =
                Rov.rows(
                        "yaw,r,main,rudder",
                        ROWS,
                        i -> {
                            double t = 0.1 * i;
                            double yaw = heading(t) + 0.01 * random.nextGaussian();
                            double told = isWrapped ? Math.IEEEremainder(yaw, 2 * Math.PI) : yaw;
                            return angle * told
                                    + ","
                                    + rate * (rate(t) + 0.02 * random.nextGaussian())
                                    + ",1,0";
                        });
        return Rov.read(folder, ColumnMapping.USUAL, text);
    }

    @ParameterizedTest(name = "{0} a radian, {1} a radian per second, wrapped: {2}")
    @CsvSource({
        "57.29578, 1, true",
        "57.29578, 1, false",
        "1, 57.29578, true",
        "1, 57.29578, false"
    })
    void oneInDegreesIsSuspected(double angle, double rate, boolean isWrapped) throws Exception {
        RunFile file = read(angle, rate, isWrapped);

        assertThat(notices(file))
                .anyMatch(said -> said.contains("columns 'yaw', 'r': one turns 57 times as far"));
        assertThat(file.doubt().isOpen(Verdict.NONE, Map.of())).isTrue();
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({"true", "false"})
    void oneThatTurnsTheOtherWayIsTold(boolean isWrapped) throws Exception {
        assertThat(notices(1, -1, isWrapped))
                .singleElement()
                .asString()
                .contains("columns 'yaw', 'r': one turns the other way");
    }

    /** A heading that counts its turns is in radians if its rate says so. */
    @ParameterizedTest(name = "{0}")
    @CsvSource({"true", "false"})
    void nothingIsSuspectedWhereTheyAgree(boolean isWrapped) throws Exception {
        assertThat(notices(1, 1, isWrapped)).isEmpty();
    }

    @Test
    void jumpsOfAnAngleAloneAreSuspected() throws Exception {
        String text =
                Rov.rows("pitch,main,rudder", ROWS, i -> 15 * Math.sin(0.2 * i + 0.1) + ",1,0");
        RunFile file = Rov.read(folder, ColumnMapping.USUAL, text);

        assertThat(notices(file))
                .singleElement()
                .asString()
                .contains("column 'pitch': angles change by more than a quarter of a turn");
        assertThat(file.doubt().isOpen(Verdict.UNEXPLAINED, Map.of())).isTrue();
    }
}
