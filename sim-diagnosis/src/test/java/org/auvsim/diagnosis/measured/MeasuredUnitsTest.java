package org.auvsim.diagnosis.measured;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.mapping.AuvsmlMapper;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.auvsml.run.MappedColumn;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.reading.RunReader;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** What others measured is in the units that its columns say, and is suspected of no others. */
@Tag("measured-data")
class MeasuredUnitsTest {
    private static final AuvsmlMapper MAPPER =
            AuvsmlMapper.load(MeasuredUnitsTest.class.getClassLoader());

    @ParameterizedTest
    @CsvSource({
        "auv-dives, auv.xml, Diver, ''",
        "simple-pendulum, pendulum.xml, Pendulum, s",
        "ship-kvlcc2, ship.xml, KVLCC2, hsva_Z",
        "ball-drops, balls.xml, baseball, baseball",
        "ball-drops, balls.xml, blue basketball, blue_basketball",
        "ball-drops, balls.xml, bowling ball, bowling_ball",
        "ball-drops, balls.xml, golf ball, golf_ball",
        "ball-drops, balls.xml, green basketball, green_basketball",
        "ball-drops, balls.xml, orange whiffle ball, orange_whiffle_ball",
        "ball-drops, balls.xml, tennis ball, tennis_ball",
        "ball-drops, balls.xml, volleyball, volleyball",
        "ball-drops, balls.xml, whiffle ball 1, whiffle_ball_1",
        "ball-drops, balls.xml, whiffle ball 2, whiffle_ball_2",
        "ball-drops, balls.xml, yellow whiffle ball, yellow_whiffle_ball",
    })
    void noUnitIsSuspected(String data, String scenario, String body, String files)
            throws Exception {
        assertThat(suspicions(DataSet.named(data), scenario, body, files, 1)).isEmpty();
    }

    /** Whatever they lack: these models have no drag. */
    @ParameterizedTest
    @ValueSource(doubles = {1000, 0.001})
    void ofFallsAnotherUnitIsSuspected(double factor) throws Exception {
        DataSet balls = DataSet.named("ball-drops");

        assertThat(suspicions(balls, "balls.xml", "golf ball", "golf_ball", factor)).hasSize(2);
        assertThat(suspicions(balls, "balls.xml", "volleyball", "volleyball", factor)).hasSize(2);
    }

    private static List<String> suspicions(
            DataSet set, String scenario, String body, String files, double factor)
            throws Exception {
        BelievedModel model = set.model(scenario, body);
        RunReader reader = new RunReader(model, mapping(set, factor), MAPPER);
        List<String> suspicions = new ArrayList<>();
        for (Path file : set.filesOf(files)) {
            if (file.toString().endsWith(".csv")) {
                reader.read(file).notices().stream()
                        .filter(notice -> notice.contains("unit") || notice.contains("1000 times"))
                        .forEach(suspicions::add);
            }
        }
        return suspicions;
    }

    /** Heights in another unit. */
    private static ColumnMapping mapping(DataSet set, double factor) throws Exception {
        ColumnMapping stated = RunReader.mapping(set.example("columns.xml"), MAPPER);
        List<MappedColumn> columns = new ArrayList<>();
        for (MappedColumn c : stated.column()) {
            boolean isHeight = c.name().equals("height_m");
            columns.add(
                    isHeight
                            ? new MappedColumn(
                                    c.name(),
                                    c.means(),
                                    c.factor() * factor,
                                    c.offset() * factor,
                                    c.form(),
                                    c.ignored(),
                                    c.lastingError(),
                                    c.runEnds())
                            : c);
        }
        return new ColumnMapping(
                stated.axes(),
                stated.degrees(),
                stated.ignoreOthers(),
                stated.start(),
                stated.shaking(),
                columns);
    }
}
