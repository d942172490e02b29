package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.nio.file.Path;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;

/** Numbers that are no possible motion are told, and treated as not measured. */
class SpikesTest {
    private static final int ROWS = 200;

    @TempDir private Path folder;

    private RunFile read(IntToDoubleFunction x) throws Exception {
        String text = Rov.rows("x,y,main,rudder", ROWS, i -> x.applyAsDouble(i) + ",0.1,0,0");
        return Rov.read(folder, ColumnMapping.USUAL, text);
    }

    private static long unmeasured(RunFile file) {
        MeasuredRun run = file.runs().getFirst();
        return IntStream.range(0, run.size())
                .filter(k -> Double.isNaN(run.value(Channel.POSITION, k, 0)))
                .count();
    }

    private static double way(int row) {
        return 3 * Math.sin(0.05 * row);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1000, -9999, 1e6, 1e9, 1e300})
    void oneOfThem(double value) throws Exception {
        RunFile file = read(i -> i == 12 ? value : way(i));

        assertThat(unmeasured(file)).isEqualTo(1);
        assertThat(file.notices())
                .filteredOn(notice -> notice.contains("no possible motion"))
                .singleElement()
                .asString()
                .startsWith(folder.resolve("run.csv") + ":14: column 'x': at 1.2 s it is ")
                .endsWith(
                        "all others lie between -3 and 3; treated as not measured; if that is"
                                + " right, leave such cells empty");
        assertThat(file.doubt()).isEqualTo(Doubt.NONE);
    }

    @Test
    void oneOfAVelocityAlongTheBodyNamesItsOwnColumn() throws Exception {
        String rows = Rov.rows("u,v,w", 60, i -> "1," + (i == 12 ? 1e6 : way(i)) + ",0.5");

        assertThat(Rov.read(folder, ColumnMapping.USUAL, rows).notices())
                .filteredOn(notice -> notice.contains("no possible motion"))
                .singleElement()
                .asString()
                .startsWith(folder.resolve("run.csv") + ":14: column 'v': ");
    }

    /** Where it is far from where it mostly is, and at either end, as well as in between. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 3, 15, 199})
    void whereverItIs(int row) throws Exception {
        RunFile file = read(i -> i == row ? 1e30 : 0.01 * way(i) + 10 * Math.exp(-0.1 * i));

        assertThat(unmeasured(file)).isEqualTo(1);
        assertThat(file.notices())
                .filteredOn(notice -> notice.contains("no possible motion"))
                .singleElement()
                .asString()
                .startsWith(folder.resolve("run.csv") + ":" + (row + 2) + ": column 'x'");
    }

    @Test
    void aMarkOfWhatWasNotMeasured() throws Exception {
        RunFile file = read(i -> i % 10 == 5 ? -9999 : way(i));

        assertThat(unmeasured(file)).isEqualTo(ROWS / 10);
        assertThat(file.notices())
                .anyMatch(notice -> notice.contains("20 readings are like the -9999 at 0.5 s"));
    }

    /** At rest nearly all the time, it goes far and comes back within a second. */
    @Test
    void aMotionIsNone() throws Exception {
        RunFile file =
                read(
                        i ->
                                0.001 * (i % 7)
                                        + (i > 150 ? 5 * Math.exp(-Math.pow(i - 160, 2) / 8) : 0));

        assertThat(unmeasured(file)).isZero();
    }

    /** It does not come back: something moved it. */
    @Test
    void aJumpIsNone() throws Exception {
        RunFile file = read(i -> i > 150 ? 1000 + way(i) : way(i));

        assertThat(unmeasured(file)).isZero();
    }
}
