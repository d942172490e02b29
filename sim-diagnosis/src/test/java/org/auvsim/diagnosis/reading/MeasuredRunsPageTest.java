package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.auvsml.run.Limit;
import org.auvsim.auvsml.run.MappedColumn;
import org.auvsim.auvsml.run.Run;
import org.auvsim.auvsml.run.RunStart;
import org.auvsim.auvsml.run.ShakingColumns;
import org.auvsim.auvsml.run.TimedPush;
import org.auvsim.core.description.ElementName;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.lang.reflect.RecordComponent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
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
