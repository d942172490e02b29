package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;

/** What is beyond the range of its sensor is not measured. */
class ClippedTest {
    private static final int ROWS = 300;

    @TempDir private Path folder;

    private RunFile read(IntToDoubleFunction x) throws Exception {
        String text =
                Rov.rows(
                        "x,y,main,rudder",
                        ROWS,
                        i -> String.format(Locale.ROOT, "%.5f,0.1,0,0", x.applyAsDouble(i)));
        return Rov.read(folder, ColumnMapping.USUAL, text);
    }

    private static long unmeasured(RunFile file) {
        MeasuredRun run = file.runs().getFirst();
        return IntStream.range(0, run.size())
                .filter(k -> Double.isNaN(run.value(Channel.POSITION, k, 0)))
                .count();
    }

    private static List<String> told(RunFile file) {
        return file.notices().stream().filter(n -> n.contains("seems to end")).toList();
    }

    private static double noise(int row) {
        return 0.05 * new Random(17L * row).nextGaussian();
    }

    private static double way(int row) {
        return 5 * Math.sin(0.04 * row);
    }

    private static long further(double end) {
        return IntStream.range(0, ROWS).filter(i -> Math.abs(way(i)) > end).count();
    }

    @Test
    void atBothEndsOfItsRange() throws Exception {
        RunFile file = read(i -> Math.clamp(way(i) + noise(i), -4, 4));

        assertThat(unmeasured(file)).isBetween(further(4.2), further(3.8));
        assertThat(told(file))
                .satisfiesExactly(
                        high ->
                                assertThat(high)
                                        .startsWith(folder.resolve("run.csv") + ":2: column 'x': ")
                                        .contains(" readings are 4 exactly, "),
                        low -> assertThat(low).contains(" readings are -4 exactly, "));
        assertThat(file.doubt()).isEqualTo(Doubt.NONE);
    }

    @Test
    void noiseAloneEndsNowhere() throws Exception {
        RunFile file = read(i -> way(i) + noise(i));

        assertThat(unmeasured(file)).isZero();
        assertThat(told(file)).isEmpty();
    }

    /** As a simulation without noise tells of what comes to rest on a floor. */
    @Test
    void whatRestsAtItsLowestIsNotBeyond() throws Exception {
        RunFile file = read(i -> Math.max(0.1, 9 * Math.exp(-0.02 * i) - 0.7));

        assertThat(unmeasured(file)).isZero();
    }

    /** Many numbers are the same where a sensor has few. */
    @Test
    void whatIsRoundedIsNotBeyond() throws Exception {
        RunFile file = read(i -> Math.rint(4 * way(i) + 4 * noise(i)) / 4);

        assertThat(unmeasured(file)).isZero();
    }
}
