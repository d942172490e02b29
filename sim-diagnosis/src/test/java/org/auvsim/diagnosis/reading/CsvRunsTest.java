package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.run.CellForm;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.auvsml.run.LastingError;
import org.auvsim.auvsml.run.Limit;
import org.auvsim.auvsml.run.MappedColumn;
import org.auvsim.auvsml.run.MeasuredAxes;
import org.auvsim.auvsml.run.RunStart;
import org.auvsim.auvsml.run.RunStart.KnownVector;
import org.auvsim.auvsml.run.ShakingColumns;
import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.Command;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.IntStream;

class CsvRunsTest {
    private static final Vec3 AHEAD = new Vec3(1, 0, 0);
    private static final Vec3 UP = new Vec3(0, 0, 1);

    @TempDir private Path folder;

    @Test
    void columnsAreWhatTheirNamesSay() throws Exception {
        MeasuredRun run =
                Rov.run(
                        folder,
                        ColumnMapping.USUAL,
                        Rov.rows(
                                "x,y,z,qw,qx,qy,qz,vx,vy,vz,p,q,r,sd_x,sd_roll",
                                20,
                                i -> i + ",2,3,0.6,0,0.8,0,4,5,6,7,8,9,0.1,0.2"));

        assertThat(run.name()).isEqualTo("run");
        assertThat(run.size()).isEqualTo(20);
        assertThat(run.time(7)).isEqualTo(0.7);
        assertThat(run.vector(Channel.POSITION, 5)).contains(new Vec3(5, 2, 3));
        assertThat(run.orientation(5)).contains(new Quat(0.6, 0, 0.8, 0));
        assertThat(run.vector(Channel.VELOCITY, 5)).contains(new Vec3(4, 5, 6));
        assertThat(run.frame(Channel.VELOCITY)).isEqualTo(Frame.WORLD);
        assertThat(run.vector(Channel.ANGULAR_VELOCITY, 5)).contains(new Vec3(7, 8, 9));
        assertThat(run.frame(Channel.ANGULAR_VELOCITY)).isEqualTo(Frame.BODY);
        assertThat(run.deviation(Channel.POSITION, 5, 0)).isEqualTo(0.1);
        assertThat(run.deviation(Channel.POSITION, 5, 1)).isNaN();
        assertThat(run.deviation(Channel.ORIENTATION, 5, 0)).isEqualTo(0.2);
    }

    @Test
    void depthAloneIsEnough() throws Exception {
        MeasuredRun run = Rov.run(folder, ColumnMapping.USUAL, Rov.rows("depth", 20, i -> "" + i));

        assertThat(run.measures(Channel.POSITION, 2)).isTrue();
        assertThat(run.measures(Channel.POSITION, 0)).isFalse();
        assertThat(run.value(Channel.POSITION, 3, 2)).isEqualTo(-3);
        assertThat(run.measures(Channel.ORIENTATION)).isFalse();
    }

    @Test
    void anEmptyCellWasNotMeasured() throws Exception {
        MeasuredRun run =
                Rov.run(
                        folder,
                        ColumnMapping.USUAL,
                        Rov.rows("x,vx", 20, i -> i % 4 == 0 ? i + ",nan" : "," + i));

        assertThat(run.value(Channel.POSITION, 4, 0)).isEqualTo(4);
        assertThat(run.value(Channel.POSITION, 5, 0)).isNaN();
        assertThat(run.value(Channel.VELOCITY, 4, 0)).isNaN();
        assertThat(run.value(Channel.VELOCITY, 5, 0)).isEqualTo(5);
    }

    @Test
    void yawAloneTurnsAboutTheVertical() throws Exception {
        MeasuredRun run =
                Rov.run(
                        folder,
                        ColumnMapping.USUAL.inDegrees(),
                        Rov.rows("yaw", 20, i -> "" + 10 * i));

        assertThat(run.measures(Channel.ORIENTATION, 0)).isFalse();
        assertThat(run.measures(Channel.ORIENTATION, 2)).isTrue();
        Vec3 ahead = run.orientation(9).orElseThrow().rotate(AHEAD);
        assertThat(ahead.distance(new Vec3(0, 1, 0))).isLessThan(1e-12);
    }

    @Test
    void anAngleThatIsNotMeasuredIsThatOfTheScenario() throws Exception {
        MeasuredRun run =
                Rov.run(folder, ColumnMapping.USUAL, Rov.rows("pitch", 20, i -> "" + 0.01 * i));

        Vec3 ahead = run.orientation(0).orElseThrow().rotate(AHEAD);
        assertThat(ahead.distance(new Vec3(0, 1, 0))).isLessThan(1e-12);
    }

    /** Whatever the vehicle heads for: about an axis of the world it would be its roll. */
    @ParameterizedTest
    @EnumSource
    void pitchWithoutRollIsMeasuredAboutTheBodysAxes(MeasuredAxes axes) throws Exception {
        MeasuredRun run =
                Rov.run(
                        folder,
                        ColumnMapping.USUAL.in(axes),
                        Rov.rows("pitch,sd_pitch", 20, i -> 0.01 * i + ",0.1"));
        MeasuredRun both =
                Rov.run(
                        folder,
                        ColumnMapping.USUAL.in(axes),
                        Rov.rows("roll,pitch", 20, i -> "0.0," + 0.01 * i));

        assertThat(run.frame(Channel.ORIENTATION)).isEqualTo(Frame.BODY);
        assertThat(run.measures(Channel.ORIENTATION, 0)).isFalse();
        assertThat(run.measures(Channel.ORIENTATION, 1)).isTrue();
        assertThat(run.deviation(Channel.ORIENTATION, 3, 1)).isEqualTo(0.1);
        assertThat(both.frame(Channel.ORIENTATION)).isEqualTo(Frame.WORLD);
    }

    @Test
    void northEastDownBecomesEastNorthUp() throws Exception {
        MeasuredRun run =
                Rov.run(
                        folder,
                        ColumnMapping.USUAL.in(MeasuredAxes.NED).inDegrees(),
                        Rov.rows(
                                "x,y,z,roll,pitch,yaw,u,v,w,wx,wy,wz,sd_x",
                                20,
                                i -> i + ",2,3,0,30,90,1,2,3,0,0,180,0.5"));

        assertThat(run.vector(Channel.POSITION, 1)).contains(new Vec3(2, 1, -3));
        assertThat(run.deviation(Channel.POSITION, 1, 1)).isEqualTo(0.5);
        Quat heading = run.orientation(1).orElseThrow();
        Vec3 east30Up = new Vec3(Math.cos(Math.PI / 6), 0, 0.5);
        assertThat(heading.rotate(AHEAD).distance(east30Up)).isLessThan(1e-12);
        assertThat(heading.rotate(UP).distance(new Vec3(-0.5, 0, Math.cos(Math.PI / 6))))
                .isLessThan(1e-12);
        assertThat(run.vector(Channel.VELOCITY, 1)).contains(new Vec3(1, -2, -3));
        assertThat(run.value(Channel.ANGULAR_VELOCITY, 1, 2)).isCloseTo(-Math.PI, within(1e-12));
    }

    @Test
    void aQuaternionInNorthEastDownTurnsAsItsAngles() throws Exception {
        double half = Math.sqrt(0.5);
        MeasuredRun run =
                Rov.run(
                        folder,
                        ColumnMapping.USUAL.in(MeasuredAxes.NED),
                        Rov.rows("x,qw,qx,qy,qz", 20, i -> i + "," + half + ",0,0," + half));

        Quat east = run.orientation(0).orElseThrow();
        assertThat(east.rotate(AHEAD).distance(new Vec3(1, 0, 0))).isLessThan(1e-12);
        assertThat(east.rotate(UP).distance(UP)).isLessThan(1e-12);
    }

    @Test
    void commandsHoldFromRowToRow() throws Exception {
        MeasuredRun run =
                Rov.run(
                        folder,
                        ColumnMapping.USUAL.inDegrees(),
                        Rov.rows(
                                "x,main,rudder,push.y",
                                20,
                                i -> i + (i % 10 == 0 ? ",0." + i / 10 + ",18,7" : ",,,")));

        assertThat(level(run, "main", 9)).isEqualTo(0);
        assertThat(level(run, "main", 11)).isEqualTo(0.1);
        assertThat(level(run, "rudder", 11)).isCloseTo(Math.PI / 10, within(1e-15));
        assertThat(level(run, "push.y", 11)).isEqualTo(7);
    }

    @Test
    void aForceByItsNameActsAlongItsVector() throws Exception {
        MeasuredRun run =
                Rov.run(
                        folder,
                        ColumnMapping.USUAL,
                        Rov.rows("x,push,main,rudder", 20, i -> i + ",10,0,0"));

        assertThat(level(run, "push.x", 3)).isEqualTo(0);
        assertThat(level(run, "push.y", 3)).isCloseTo(6, within(1e-12));
        assertThat(level(run, "push.z", 3)).isCloseTo(8, within(1e-12));
    }

    @Test
    void anActuatorWithoutAColumnHoldsWhatTheScenarioSays() throws Exception {
        RunFile file = Rov.read(folder, ColumnMapping.USUAL, Rov.rows("x,main", 20, i -> i + ",0"));

        assertThat(file.notices())
                .containsExactly(
                        folder.resolve("run.csv")
                                + ":1: column 'rudder': expected the angle of the fin, but the"
                                + " header has no such column: it holds the scenario's 0.0; add the"
                                + " column, or rename the one that has it (--rename"
                                + " COLUMN=rudder)");
    }

    @Test
    void severalActuatorsWithoutColumnsAreToldAtOnce() throws Exception {
        RunFile file = Rov.read(folder, ColumnMapping.USUAL, Rov.rows("x", 20, i -> "" + i));

        assertThat(file.notices())
                .containsExactly(
                        folder.resolve("run.csv")
                                + ":1: columns 'main', 'rudder': no column gives the commands of"
                                + " these actuators, so they keep the scenario's values; add the"
                                + " columns, or rename those that have them (--rename"
                                + " COLUMN=main)");
    }

    @Test
    void aMappingRenamesScalesAndIgnores() throws Exception {
        ColumnMapping mapping =
                ColumnMapping.USUAL.with(
                        List.of(
                                MappedColumn.renamed("time_s", "t"),
                                new MappedColumn(
                                        "pwm",
                                        Optional.of("main"),
                                        0.0025,
                                        -3.75,
                                        CellForm.NUMBER,
                                        false),
                                MappedColumn.ignored("volt")));
        String text = Rov.rows("x,pwm,volt", 20, i -> i + ",1700,low").replace("t,x", "time_s,x");

        MeasuredRun run = Rov.run(folder, mapping, text);

        assertThat(level(run, "main", 0)).isCloseTo(0.5, within(1e-12));
        assertThat(run.time(3)).isEqualTo(0.3);
    }

    @Test
    void otherColumnsAreLeftOutIfAskedFor() throws Exception {
        MeasuredRun run =
                Rov.run(
                        folder,
                        ColumnMapping.USUAL.ignoringOthers(),
                        Rov.rows("x,voltage", 20, i -> i + ",12.1"));

        assertThat(run.commands()).isEmpty();
    }

    @Test
    void semicolonsAndTabsSeparate() throws Exception {
        String text = Rov.rows("x,y", 20, i -> i + ",1");

        assertThat(Rov.run(folder, ColumnMapping.USUAL, text.replace(',', ';')).size())
                .isEqualTo(20);
        assertThat(Rov.run(folder, ColumnMapping.USUAL, text.replace(',', '\t')).size())
                .isEqualTo(20);
    }

    @Test
    void rowsThatSayOfWhichRunTheyAreBeginItAnew() throws Exception {
        StringBuilder text = new StringBuilder("run,t,x\n");
        for (int row = 0; row < 40; row++) {
            text.append(
                    String.format(Locale.ROOT, "%d,%.1f,%d%n", row / 20, 0.1 * (row % 20), row));
        }
        RunFile file = Rov.read(folder, ColumnMapping.USUAL, text.toString());

        assertThat(file.runs())
                .extracting(MeasuredRun::name, MeasuredRun::size)
                .containsExactly(tuple("run", 20), tuple("run-2", 20));
        assertThat(file.runs().get(1).time(0)).isZero();
        assertThat(file.runs().get(1).value(Channel.POSITION, 0, 0)).isEqualTo(20);
        assertThat(file.notices()).noneMatch(notice -> notice.contains("without a row"));
    }

    @Test
    void eachRunOfAFileBeginsAsItsDocumentSays() throws Exception {
        Rov.write(
                folder.resolve("run.xml"),
                "<run><start><velocity x='1' y='2' z='3' deviation='0.5'/></start></run>");
        String rows = Rov.rows("run,x", 40, i -> i / 20 + "," + i);
        RunFile file = Rov.read(folder, ColumnMapping.USUAL, rows);

        assertThat(file.runs())
                .hasSize(2)
                .allSatisfy(
                        run ->
                                assertThat(run.start().orElseThrow().motion().velocity())
                                        .isEqualTo(new Vec3(1, 2, 3)));
    }

    @Test
    void runsBeginAsTheMappingSaysWhereTheirDocumentsDoNot() throws Exception {
        KnownVector surface = new KnownVector(0, 0, -0.5, 0.03);
        RunStart start =
                new RunStart(
                        Optional.of(surface), Optional.empty(), Optional.empty(), Optional.empty());
        ColumnMapping mapping =
                new ColumnMapping(MeasuredAxes.ENU, false, false, Optional.of(start), List.of());
        String rows = Rov.rows("x", 20, i -> "" + i);

        KnownStart known = Rov.run(folder, mapping, rows).start().orElseThrow();
        assertThat(known.motion().position()).isEqualTo(new Vec3(0, 0, -0.5));
        assertThat(known.deviations().subList(0, 4))
                .containsExactly(0.03, 0.03, 0.03, Double.POSITIVE_INFINITY);

        Rov.write(
                folder.resolve("run.xml"),
                "<run><start><position x='7' y='0' z='0' deviation='1'/></start></run>");
        assertThat(Rov.run(folder, mapping, rows).start().orElseThrow().motion().position())
                .isEqualTo(new Vec3(7, 0, 0));
    }

    @Test
    void errorsThatLastAreThoseOfTheRunsAxes() throws Exception {
        ColumnMapping mapping =
                new ColumnMapping(
                        MeasuredAxes.NED,
                        true,
                        false,
                        Optional.empty(),
                        List.of(lasting("x", 0.1), lasting("depth", 0.2), lasting("roll", 3)));
        MeasuredRun run =
                Rov.run(folder, mapping, Rov.rows("x,depth,roll", 20, i -> i + ",2," + i));

        assertThat(run.lastingErrors(Channel.POSITION, 1))
                .containsExactly(new LastingError(0.1, 5));
        assertThat(run.lastingErrors(Channel.POSITION, 2))
                .containsExactly(new LastingError(0.2, 5));
        assertThat(run.lastingErrors(Channel.POSITION, 0)).isEmpty();
        assertThat(run.lastingErrors(Channel.ORIENTATION, 0).getFirst().deviation())
                .isCloseTo(Math.toRadians(3), within(1e-12));
        assertThat(run.part("part", 2, 9).lastingErrors(Channel.POSITION, 1)).isNotEmpty();
    }

    private static MappedColumn lasting(String name, double deviation) {
        return new MappedColumn(
                name,
                Optional.empty(),
                1,
                0,
                CellForm.NUMBER,
                false,
                List.of(new LastingError(deviation, 5)),
                Optional.empty());
    }

    private static ColumnMapping ending(String column, Limit limit) {
        return ColumnMapping.USUAL
                .ignoringOthers()
                .with(
                        List.of(
                                new MappedColumn(
                                        column,
                                        Optional.empty(),
                                        0.5,
                                        0,
                                        CellForm.NUMBER,
                                        false,
                                        List.of(),
                                        Optional.of(limit))));
    }

    /** In the unit that the mapping makes of it, whether the column has a usual name or not. */
    @Test
    void aRunEndsBeforeANumberBeyondALimit() throws Exception {
        String text = Rov.rows("depth,height", 40, i -> i + "," + (50 - i));

        RunFile deep =
                Rov.read(
                        folder,
                        ending("depth", new Limit(Optional.of(12.0), Optional.empty())),
                        text);
        RunFile low =
                Rov.read(
                        folder,
                        ending("height", new Limit(Optional.empty(), Optional.of(14.0))),
                        text);

        assertThat(deep.runs()).extracting(MeasuredRun::size).containsExactly(25);
        assertThat(deep.notices())
                .contains(
                        folder.resolve("run.csv")
                                + ":27: the run ends 2.5 s after its first row, where 'depth' is"
                                + " 12.5; what follows is left out");
        assertThat(low.runs()).extracting(MeasuredRun::size).containsExactly(23);
    }

    /** What follows of it is left out, also where the number comes back; the next run is whole. */
    @Test
    void theNextRunOfAFileBeginsAnew() throws Exception {
        RunFile file =
                Rov.read(
                        folder,
                        ending("x", new Limit(Optional.of(8.9), Optional.empty())),
                        Rov.rows("run,x", 60, i -> i / 40 + "," + i % 20));

        assertThat(file.runs()).extracting(MeasuredRun::size).containsExactly(18, 18);
    }

    @Test
    void whatTellsOfShakingIsTakenAsItIs() throws Exception {
        ColumnMapping mapping =
                new ColumnMapping(
                        MeasuredAxes.NED,
                        true,
                        true,
                        Optional.empty(),
                        Optional.of(new ShakingColumns("a_x", "q")),
                        List.of(MappedColumn.ignored("a_x")));
        MeasuredRun run =
                Rov.run(folder, mapping, Rov.rows("x,a_x,q", 20, i -> i + "," + 2 * i + ",-" + i));

        assertThat(run.acceleration(3)).isEqualTo(6);
        assertThat(run.rate(3)).isEqualTo(-3);
        assertThat(run.part("part", 2, 19).acceleration(1)).isEqualTo(6);
        assertThat(run.value(Channel.ANGULAR_VELOCITY, 3, 1))
                .isCloseTo(Math.toRadians(3), within(1e-12));
        assertThat(Rov.run(folder, ColumnMapping.USUAL, Rov.rows("x", 20, i -> "" + i)))
                .extracting(MeasuredRun::tellsShaking)
                .isEqualTo(false);
    }

    @Test
    void ofManyRowsSomeAreLeftOutButNoCommandIs() throws Exception {
        int count = 100_000;
        StringBuilder text = new StringBuilder("t,x,main,rudder\n");
        for (int i = 0; i < count; i++) {
            text.append(i / 1000.0).append(',').append(i).append(',');
            text.append(i < 50_003 ? 0.25 : i == 50_003 ? -1 : 0.5).append(",0\n");
        }

        RunFile file = Rov.read(folder, ColumnMapping.USUAL, text.toString());

        MeasuredRun run = file.runs().getFirst();
        assertThat(run.size()).isBetween(20_000, 20_004);
        assertThat(changes(run)).containsExactly(0.0, 50.003, 50.004);
        assertThat(run.value(Channel.POSITION, 1, 0)).isEqualTo(5);
        assertThat(file.notices())
                .contains(
                        folder.resolve("run.csv")
                                + ": every 5th of 100000 rows is used, plus all rows in which a"
                                + " command changes");
    }

    /** A fix of the position once a second among rows of a fast depth sensor. */
    @Test
    void ofManyRowsNoneOfAColumnThatHasFewIsLeftOut() throws Exception {
        int count = 100_000;
        StringBuilder text = new StringBuilder("t,x,z,main,rudder\n");
        for (int i = 0; i < count; i++) {
            text.append(i / 100.0).append(',');
            text.append(i % 100 == 3 ? i : "").append(',').append(i).append(",0.25,0\n");
        }

        MeasuredRun run = Rov.run(folder, ColumnMapping.USUAL, text.toString());

        assertThat(numbers(run, 0)).containsExactlyElementsOf(every(100, 3, count));
        assertThat(numbers(run, 2)).containsExactlyElementsOf(every(5, 0, count));
    }

    private static List<Double> every(int each, int from, int count) {
        return IntStream.iterate(from, i -> i < count, i -> i + each)
                .mapToObj(i -> (double) i)
                .toList();
    }

    private static List<Double> numbers(MeasuredRun run, int axis) {
        return IntStream.range(0, run.size())
                .mapToObj(k -> run.value(Channel.POSITION, k, axis))
                .filter(x -> !Double.isNaN(x))
                .toList();
    }

    private static List<Double> changes(MeasuredRun run) {
        Command main = command(run, "main");
        return IntStream.range(0, run.size()).filter(main::changesAt).mapToObj(run::time).toList();
    }

    private static Command command(MeasuredRun run, String name) {
        return run.commands().stream().filter(c -> c.name().equals(name)).findFirst().orElseThrow();
    }

    private static double level(MeasuredRun run, String name, int sample) {
        return command(run, name).level(sample);
    }
}
