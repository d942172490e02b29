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

/** A fix that a logger writes until the next one comes is one measurement. */
class HeldTest {
    private static final int ROWS = 200;

    @TempDir private Path folder;

    private RunFile read(String columns, IntFunction<String> row) throws Exception {
        String text = Rov.rows(columns + ",main,rudder", ROWS, i -> row.apply(i) + ",0,0");
        return Rov.read(folder, ColumnMapping.USUAL, text);
    }

    private static List<Integer> measured(RunFile file, Channel channel, int axis) {
        MeasuredRun run = file.runs().getFirst();
        return IntStream.range(0, run.size())
                .filter(k -> !Double.isNaN(run.value(channel, k, axis)))
                .boxed()
                .toList();
    }

    private static List<String> told(RunFile file) {
        return file.notices().stream().filter(n -> n.contains("stays the same")).toList();
    }

    private static String text(double number) {
        return String.format(Locale.ROOT, "%.3f", number);
    }

    /** With the noise of a sensor that tells of row k. */
    private static double noisy(int k) {
        return 3 * Math.sin(0.03 * k) + 0.1 * new Random(31L * k).nextGaussian();
    }

    @Test
    void aFixOfEveryFifthRowIsOne() throws Exception {
        RunFile file =
                read(
                        "x,y,z",
                        i ->
                                text(noisy(i / 5 * 5))
                                        + ","
                                        + text(Math.floorDiv(i, 5))
                                        + ","
                                        + text(noisy(i)));

        assertThat(measured(file, Channel.POSITION, 0))
                .containsExactlyElementsOf(IntStream.range(0, 40).map(i -> 5 * i).boxed().toList());
        assertThat(measured(file, Channel.POSITION, 2)).hasSize(ROWS);
        assertThat(told(file))
                .singleElement()
                .asString()
                .startsWith(folder.resolve("run.csv") + ":2: column 'x': each number stays the")
                .contains(" for 5 rows, ");
        assertThat(file.doubt()).isEqualTo(Doubt.NONE);
    }

    @Test
    void aHeadingAndAVelocityAreHeldAsAPlaceIs() throws Exception {
        RunFile file =
                read("yaw,u", i -> text(0.3 * noisy(i / 10 * 10)) + "," + text(noisy(i / 4 * 4)));

        assertThat(measured(file, Channel.ORIENTATION, 2)).hasSize(ROWS / 10);
        assertThat(measured(file, Channel.VELOCITY, 0)).hasSize(ROWS / 4);
        assertThat(told(file))
                .satisfiesExactly(
                        first -> assertThat(first).contains("'u'").contains("4 rows"),
                        second -> assertThat(second).contains("'yaw'").contains("10 rows"));
    }

    /** Now and then a row more or less. */
    @Test
    void clocksThatDifferMakeNoDifference() throws Exception {
        RunFile file = read("x,y,z", i -> text(noisy((int) (i / 4.7))) + ",0,0");

        assertThat(measured(file, Channel.POSITION, 0)).hasSize(43);
    }

    @Test
    void whatIsRoundedIsNotHeld() throws Exception {
        RunFile file = read("x,y,z", i -> text(0.1 * Math.floorDiv(i, 5)) + ",0,0");

        assertThat(measured(file, Channel.POSITION, 0)).hasSize(ROWS);
        assertThat(told(file)).isEmpty();
    }

    @Test
    void whatRestsForAWhileIsNotHeld() throws Exception {
        RunFile file = read("x,y,z", i -> text(noisy(Math.max(i, 120))) + ",0,0");

        assertThat(measured(file, Channel.POSITION, 0)).hasSize(ROWS);
        assertThat(told(file)).isEmpty();
    }
}
