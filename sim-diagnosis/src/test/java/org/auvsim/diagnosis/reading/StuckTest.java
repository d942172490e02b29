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
import java.util.function.IntFunction;
import java.util.stream.IntStream;

/** What a sensor that stopped goes on to tell is not measured. */
class StuckTest {
    private static final int ROWS = 200;

    @TempDir private Path folder;

    private RunFile read(String columns, IntFunction<String> row) throws Exception {
        String text = Rov.rows(columns + ",main,rudder", ROWS, i -> row.apply(i) + ",0,0");
        return Rov.read(folder, ColumnMapping.USUAL, text);
    }

    private static List<Integer> unmeasured(RunFile file, Channel channel, int axis) {
        MeasuredRun run = file.runs().getFirst();
        return IntStream.range(0, run.size())
                .filter(k -> Double.isNaN(run.value(channel, k, axis)))
                .boxed()
                .toList();
    }

    private static List<Integer> rows(int from, int to) {
        return IntStream.rangeClosed(from, to).boxed().toList();
    }

    private static List<String> told(RunFile file) {
        return file.notices().stream().filter(n -> n.contains("stuck")).toList();
    }

    private static String text(double... numbers) {
        StringBuilder text = new StringBuilder();
        for (double number : numbers) {
            text.append(text.isEmpty() ? "" : ",")
                    .append(String.format(Locale.ROOT, "%.6f", number));
        }
        return text.toString();
    }

    private static double noisy(int row, int seed) {
        return 2 * Math.sin(0.03 * row) + 0.1 * new Random(31L * row + seed).nextGaussian();
    }

    @Test
    void untilTheEndOrForAWhile() throws Exception {
        RunFile file =
                read(
                        "x,y,z",
                        i ->
                                text(
                                        noisy(Math.min(i, 130), 1),
                                        noisy(i, 2),
                                        noisy(50 < i && i < 90 ? 50 : i, 3)));

        assertThat(unmeasured(file, Channel.POSITION, 0)).isEqualTo(rows(131, ROWS - 1));
        assertThat(unmeasured(file, Channel.POSITION, 1)).isEmpty();
        assertThat(unmeasured(file, Channel.POSITION, 2)).isEqualTo(rows(51, 89));
        assertThat(told(file))
                .containsExactly(
                        folder.resolve("run.csv")
                                + ":132: column 'x': to the last digit the same from 13 to 19.9 s,"
                                + " though noise changes it from row to row elsewhere, as if a"
                                + " sensor was stuck; treated as not measured there; if that is"
                                + " right, leave such cells empty",
                        folder.resolve("run.csv")
                                + ":52: column 'z': to the last digit the same from 5 to 8.9 s,"
                                + " though noise changes it from row to row elsewhere, as if a"
                                + " sensor was stuck; treated as not measured there; if that is"
                                + " right, leave such cells empty");
        assertThat(file.doubt()).isEqualTo(Doubt.NONE);
    }

    /** All of an orientation at once, or its heading alone. */
    @Test
    void anOrientationIsWhollyOrByOneAngle() throws Exception {
        RunFile whole =
                read(
                        "x,roll,pitch,yaw",
                        i -> {
                            int row = Math.min(i, 150);
                            return text(
                                    noisy(i, 1),
                                    0.1 * noisy(row, 2),
                                    0.1 * noisy(row, 3),
                                    noisy(row, 4));
                        });
        RunFile heading =
                read(
                        "x,roll,pitch,yaw",
                        i ->
                                text(
                                        noisy(i, 1),
                                        0.1 * noisy(i, 2),
                                        0.1 * noisy(i, 3),
                                        noisy(Math.min(i, 150), 4)));

        for (int axis = 0; axis < 3; axis++) {
            assertThat(whole.runs().getFirst().samples(Channel.ORIENTATION, axis)).hasSize(151);
            assertThat(heading.runs().getFirst().samples(Channel.ORIENTATION, axis))
                    .hasSize(axis < 2 ? ROWS : 151);
        }
        assertThat(told(whole)).singleElement().asString().contains("'pitch', 'roll', 'yaw'");
        assertThat(told(heading)).singleElement().asString().contains("column 'yaw'");
    }

    /** As a simulation without noise tells of what comes to rest. */
    @Test
    void whatRestsWithoutNoiseIsMeasured() throws Exception {
        RunFile file = read("x,y", i -> text(Math.max(1, 9 * Math.exp(-0.02 * i)), noisy(i, 2)));

        assertThat(unmeasured(file, Channel.POSITION, 0)).isEmpty();
    }

    /** Some sensors tell nothing new of what rests; it goes on from there. */
    @Test
    void whatAllTellToRestIsMeasured() throws Exception {
        RunFile file = read("x,y", i -> text(noisy(Math.max(i, 80), 1), noisy(Math.max(i, 80), 2)));

        assertThat(told(file)).isEmpty();
    }

    /** All of it was lost for a while. */
    @Test
    void whatGoesOnElsewhereWasStuck() throws Exception {
        RunFile file = read("x", i -> text(noisy(40 < i && i < 90 ? 40 : i, 1)));

        assertThat(unmeasured(file, Channel.POSITION, 0)).isEqualTo(rows(41, 89));
    }

    /** Of a coarse sensor a body that rests is at one number, too. */
    @Test
    void whatIsRoundedIsMeasured() throws Exception {
        RunFile file =
                read(
                        "x,y",
                        i -> text(Math.rint(10 * noisy(Math.min(i, 100), 0)) / 10, noisy(i, 2)));

        assertThat(told(file)).isEmpty();
    }
}
