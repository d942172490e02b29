package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.AuvsmlException;
import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.auvsml.run.Limit;
import org.auvsim.auvsml.run.MappedColumn;
import org.auvsim.auvsml.run.Run;
import org.auvsim.auvsml.run.RunStart;
import org.auvsim.auvsml.run.ShakingColumns;
import org.auvsim.auvsml.run.TimedPush;
import org.auvsim.core.description.ElementName;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.Command;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.lang.reflect.RecordComponent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** docs/measured-runs.md has every column, and every part of the documents. */
class MeasuredRunsPageTest {
    private static final Path PAGE = Path.of("..", "docs", "measured-runs.md");

    @Test
    void everyColumnIsThere() throws IOException {
        String page = Files.readString(PAGE);

        assertThat(Slots.byName().keySet())
                .filteredOn(name -> !name.startsWith("sd_"))
                .allSatisfy(name -> assertThat(page).contains("`" + name + "`"));
    }

    /** Of the log the page has the first rows; those behind them are like its second. */
    @Test
    void theLogOfABoatIsReadAsThePageSays(@TempDir Path folder) throws Exception {
        String log = block("    unix_time,");
        String second = log.lines().toList().get(2);
        StringBuilder rows = new StringBuilder(log);
        for (int i = 2; i < 40; i++) {
            String time = String.format(Locale.ROOT, "%.3f", 1_718_000_000 + 0.05 * i);
            rows.append(second.replace("1718000000.050", time)).append('\n');
        }
        Path mapping =
                Files.writeString(
                        folder.resolve("lab.xml"),
                        block("    <column-mapping axes=\"NED\" degrees=\"1\" ignore"));
        Path file = Files.writeString(folder.resolve("log_a.csv"), rows);

        MeasuredRun run =
                new RunReader(boat(), RunReader.mapping(mapping, Rov.MAPPER), Rov.MAPPER)
                        .read(file)
                        .runs()
                        .getFirst();

        assertThat(run.size()).isEqualTo(40);
        assertThat(run.time(1) - run.time(0)).isCloseTo(0.05, within(1e-6));
        assertThat(run.value(Channel.POSITION, 0, 0)).as("east").isEqualTo(0.246);
        assertThat(run.value(Channel.POSITION, 0, 1)).as("north").isEqualTo(0.104);
        assertThat(run.value(Channel.POSITION, 1, 0)).isNaN();
        Vec3 ahead = run.orientation(0).orElseThrow().rotate(new Vec3(1, 0, 0));
        assertThat(Math.toDegrees(Math.atan2(ahead.x(), ahead.y()))).isCloseTo(67.25, within(1e-9));
        assertThat(run.value(Channel.ANGULAR_VELOCITY, 0, 2))
                .as("to the left")
                .isCloseTo(Math.toRadians(-0.272), within(1e-12));
        assertThat(run.commands()).extracting(Command::name).containsExactly("port", "starboard");
        assertThat(run.commands().getLast().level(0)).isZero();
        assertThat(run.commands().getLast().level(1)).isCloseTo(0.3, within(1e-12));
    }

    private static BelievedModel boat() throws AuvsmlException {
        String scenario =
                """
                <scenario>
                  <time-step delta="0.05"/>
                  <world-object name="Boat" mass="25">
                    <box><size x="1.2" y="0.8" z="0.3"/></box>
                    <held z="1" turn-x="1" turn-y="1"/>
                    <propulsor name="port" maximum-thrust="20"/>
                    <propulsor name="starboard" maximum-thrust="20"/>
                  </world-object>
                </scenario>
                """;
        return new BelievedModel(
                ScenarioLoader.load(Rov.LOADER).parse(scenario.getBytes(UTF_8)), "Boat");
    }

    /** The block of the page that begins so, without its indentation. */
    private static String block(String begin) throws IOException {
        String page = Files.readString(PAGE);
        return page.substring(page.indexOf("\n" + begin) + 1)
                .lines()
                .takeWhile(line -> line.startsWith("    "))
                .map(String::strip)
                .collect(Collectors.joining("\n", "", "\n"));
    }

    @Test
    void everyPartOfTheDocumentsIsThere() throws IOException {
        String page = Files.readString(PAGE);

        assertThat(
                        Stream.of(
                                        Run.class,
                                        RunStart.class,
                                        TimedPush.class,
                                        ColumnMapping.class,
                                        ShakingColumns.class,
                                        MappedColumn.class,
                                        Limit.class)
                                .flatMap(type -> Arrays.stream(type.getRecordComponents()))
                                .map(RecordComponent::getName)
                                .map(ElementName::of))
                .allSatisfy(name -> assertThat(page).contains("`" + name + "`"));
    }
}
