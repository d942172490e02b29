package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.run.CellForm;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.auvsml.run.MappedColumn;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Times of rows: taken as they stand, but for whole seconds that several rows share. */
class TimeStampsTest {
    @TempDir private Path folder;

    @Test
    void wholeSecondsWithSeveralRowsAreAConstantRate() throws Exception {
        StringBuilder text = new StringBuilder("t,x\n");
        for (int i = 0; i < 100; i++) {
            text.append((i + 3) / 8).append(',').append(i).append('\n');
        }

        RunFile file = Rov.read(folder, ColumnMapping.USUAL, text.toString());

        MeasuredRun run = file.runs().getFirst();
        assertThat(run.size()).isEqualTo(100);
        assertThat(run.time(80) - run.time(0)).isCloseTo(10, within(1e-9));
        assertThat(file.notices())
                .contains(
                        folder.resolve("run.csv")
                                + ": column 't': times are whole seconds with several rows each;"
                                + " read as a constant rate of 8 Hz");
    }

    /** The seconds in which a run begins or ends may not be whole. */
    @Test
    void wholeSecondsOfSeveralRunsAreOfOneRate() throws Exception {
        StringBuilder text = new StringBuilder("run,t,x\n");
        for (int run = 1; run <= 3; run++) {
            for (int i = 0; i < 96; i++) {
                text.append(run).append(',').append((i + 3) / 8).append(',').append(i).append('\n');
            }
        }

        RunFile file = Rov.read(folder, ColumnMapping.USUAL, text.toString());

        assertThat(file.runs()).hasSize(3);
        assertThat(file.notices()).anyMatch(notice -> notice.endsWith(" rate of 8 Hz"));
    }

    /** The usual interval of these is 0.1 s. */
    static Stream<Arguments> stamps() {
        Random lot = new Random(7);
        return Stream.of(
                Arguments.of(
                        "uneven", (IntToDoubleFunction) i -> Math.floorDiv(i, 3) + 0.1 * (i % 3)),
                Arguments.of(
                        "jittered", (IntToDoubleFunction) i -> 0.1 * i + 0.08 * lot.nextDouble()),
                Arguments.of(
                        "two after a late one",
                        (IntToDoubleFunction) i -> i % 10 == 4 ? 0.1 * i + 0.07 : 0.1 * i),
                Arguments.of("lost rows", (IntToDoubleFunction) i -> 0.1 * (i + i / 4)),
                Arguments.of("faster", (IntToDoubleFunction) i -> i < 30 ? 0.1 * i : 0.01 * i + 3),
                Arguments.of(
                        "a gap", (IntToDoubleFunction) i -> i < 20 ? 0.1 * i : 0.1 * i + 5.004),
                Arguments.of("whole seconds, once each", (IntToDoubleFunction) i -> i + i / 7));
    }

    /** Whatever their intervals are. */
    @ParameterizedTest(name = "{0}")
    @MethodSource("stamps")
    void timesAreThoseOfTheFile(String kind, IntToDoubleFunction stamp) throws Exception {
        List<Double> stamps = IntStream.range(0, 60).mapToDouble(stamp).boxed().toList();
        StringBuilder text = new StringBuilder("t,x\n");
        stamps.forEach(t -> text.append(t).append(',').append(3 * t).append('\n'));

        List<MeasuredRun> runs = Rov.read(folder, ColumnMapping.USUAL, text.toString()).runs();

        assertThat(runs).hasSize(kind.equals("a gap") ? 2 : 1);
        List<Double> times = new ArrayList<>();
        for (MeasuredRun run : runs) {
            IntStream.range(0, run.size()).forEach(k -> times.add(run.time(k)));
        }
        assertThat(times).isEqualTo(stamps);
    }

    /** Seconds with 3, 5 and 4 rows; then some are missing, and the rate begins anew. */
    @Test
    void aConstantRateBeginsAnewWhereSecondsAreMissing() throws Exception {
        StringBuilder text = new StringBuilder("t,x\n");
        int row = 0;
        for (int second = 0; second < 24; second++) {
            int stamp = second < 12 ? second : second + 60;
            for (int i = 0; i < new int[] {3, 5, 4}[second % 3]; i++) {
                text.append(stamp).append(',').append(row++).append('\n');
            }
        }

        List<MeasuredRun> runs = Rov.read(folder, ColumnMapping.USUAL, text.toString()).runs();

        assertThat(runs).hasSize(2);
        double interval = runs.getFirst().time(1);
        assertThat(interval).isCloseTo(0.25, within(0.01));
        assertThat(runs.getFirst().time(47)).isCloseTo(47 * interval, within(1e-9));
        assertThat(runs.get(1).time(0)).isEqualTo(72);
        assertThat(runs.get(1).time(47)).isCloseTo(72 + 47 * interval, within(1e-9));
    }

    @Test
    void timesOfDayCountInSeconds() throws Exception {
        ColumnMapping mapping =
                ColumnMapping.USUAL.with(
                        List.of(
                                new MappedColumn(
                                        "t", Optional.empty(), 1, 0, CellForm.HHMMSS, false)));
        StringBuilder text = new StringBuilder("t,x\n");
        for (int i = 0; i < 40; i++) {
            int seconds = 50 + i / 4;
            text.append(String.format(Locale.ROOT, "2052%02d", seconds)).append(',').append(i);
            text.append('\n');
        }
        String crossing = text.toString().replace("205260", "205300");

        RunFile file = Rov.read(folder, mapping, crossing);

        assertThat(file.runs()).hasSize(1);
        MeasuredRun run = file.runs().getFirst();
        assertThat(run.time(0)).isEqualTo(20 * 3600 + 52 * 60 + 50);
        assertThat(run.time(39) - run.time(0)).isCloseTo(39 * 0.25, within(1e-9));
    }

    private static ColumnMapping timesAs(CellForm form) {
        return ColumnMapping.USUAL.with(
                List.of(new MappedColumn("t", Optional.empty(), 1, 0, form, false)));
    }

    /** 23:59:59.0 to 00:00:02.9. */
    @Test
    void timesOfDayCountOnPastMidnight() throws Exception {
        StringBuilder text = new StringBuilder("t,x\n");
        for (int i = 0; i < 40; i++) {
            int second = i / 10;
            String clock = second == 0 ? "235959" : "00000" + (second - 1);
            text.append(clock).append('.').append(i % 10).append(',').append(i).append('\n');
        }

        RunFile file = Rov.read(folder, timesAs(CellForm.HHMMSS), text.toString());

        assertThat(file.runs()).hasSize(1);
        MeasuredRun run = file.runs().getFirst();
        assertThat(run.time(0)).isEqualTo(86_399);
        assertThat(run.time(39)).isCloseTo(86_402.9, within(1e-9));
        assertThat(file.notices())
                .contains(
                        folder.resolve("run.csv")
                                + ":12: column 't': times of day begin anew; they are read as"
                                + " going on past midnight, into the next day");
    }

    /** Half an hour back is no midnight. */
    @Test
    void timesOfDayThatStepBackAreRefused() {
        StringBuilder text = new StringBuilder("t,x\n");
        for (int i = 0; i < 40; i++) {
            text.append(i == 20 ? "115000" : "1220" + (10 + i)).append(',').append(i).append('\n');
        }

        assertThatThrownBy(() -> Rov.read(folder, timesAs(CellForm.HHMMSS), text.toString()))
                .hasMessageContaining("run.csv:22: column 't': expected a time after 44429.0 s");
    }

    /** 12:00 UTC on 10 June 2024 is 1718020800 s after 1970. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "2024-06-10T12:00:%04.1f",
                "2024-06-10 12:00:%04.1f",
                "2024-06-10T12:00:%04.1fZ",
                "2024-06-10T14:00:%04.1f+02:00",
                "2024-06-10T14:00:%04.1f+0200",
                "2024-06-10T14:00:%04.1f+02",
                "2024-06-10t06:30:%04.1f000-05:30"
            })
    void datesCountInSecondsSince1970(String form) throws Exception {
        StringBuilder text = new StringBuilder("t,x\n");
        for (int i = 0; i < 40; i++) {
            text.append(String.format(Locale.ROOT, form, 0.1 * i)).append(',').append(i);
            text.append('\n');
        }

        MeasuredRun run = Rov.run(folder, timesAs(CellForm.ISO_8601), text.toString());

        assertThat(run.time(0)).isEqualTo(1_718_020_800);
        assertThat(run.time(39)).isCloseTo(1_718_020_803.9, within(1e-6));
    }

    @Test
    void aLongGapBeginsAnotherRun() throws Exception {
        String text = Rov.rows("x", 40, i -> "" + i);
        String late = text.replaceAll("(?m)^(2|3)\\.(\\d),", "1$1.$2,");

        RunFile file = Rov.read(folder, ColumnMapping.USUAL, late);

        assertThat(file.runs()).extracting(MeasuredRun::name).containsExactly("run", "run-2");
        assertThat(file.runs()).extracting(MeasuredRun::size).containsExactly(20, 20);
        assertThat(file.runs()).extracting(MeasuredRun::beginsMidway).containsExactly(false, true);
        assertThat(file.notices())
                .anyMatch(
                        text1 ->
                                text1.equals(
                                        folder.resolve("run.csv")
                                                + ":22: column 't': 10.1 s without a row after 1.9"
                                                + " s; what follows is"
                                                + " read as another run"));
    }
}
