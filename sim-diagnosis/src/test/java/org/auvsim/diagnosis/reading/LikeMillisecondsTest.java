package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.auvsml.document.DocumentException;
import org.auvsim.auvsml.run.CellForm;
import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.auvsml.run.MappedColumn;
import org.auvsim.auvsml.run.MeasuredAxes;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** 40 s at 10 Hz, their times in milliseconds; the model goes in steps of 0.1 s. */
class LikeMillisecondsTest {
    private static final int ROWS = 401;

    @TempDir private Path folder;
    private Path run = Path.of("");

    @BeforeEach
    void begin() throws IOException {
        StringBuilder text = new StringBuilder("t,yaw,main,rudder\n");
        for (int i = 0; i < ROWS; i++) {
            text.append(100 * i).append(',').append(0.01 * i).append(",0.5,0\n");
        }
        run = Rov.write(folder.resolve("run.csv"), text.toString());
    }

    private static ColumnMapping scaledBy(double scale) {
        return new ColumnMapping(
                MeasuredAxes.ENU,
                false,
                false,
                Optional.empty(),
                List.of(new MappedColumn("t", Optional.empty(), scale, 0, CellForm.NUMBER, false)));
    }

    @Test
    void takenForSecondsTheyAreRefusedWhereASearchWouldTakeHours() {
        assertThatThrownBy(() -> Rov.reader(ColumnMapping.USUAL).read(run))
                .isInstanceOf(DocumentException.class)
                .hasMessage(
                        run
                                + ":2: column 't': rows are 100 s apart by whole numbers, 40000 s"
                                + " in all, and a search in 400000 time steps of 0.1 s would take"
                                + " hours: map 't' with a scale of 0.001 if these are milliseconds,"
                                + " or of 1 if they are seconds (--mapping)");
    }

    @Test
    void aStatedScaleIsBelieved() throws Exception {
        RunFile milliseconds = Rov.reader(scaledBy(0.001)).read(run);
        RunFile seconds = Rov.reader(scaledBy(1)).read(run);

        assertThat(milliseconds.runs().getFirst().duration()).isEqualTo(40);
        assertThat(seconds.runs().getFirst().duration()).isEqualTo(40_000);
        assertThat(seconds.notices()).noneMatch(notice -> notice.contains("milliseconds"));
        assertThat(seconds.doubt()).isEqualTo(Doubt.NONE);
    }

    /** 9 900 s are few enough steps: they can be used, and are suspected. */
    @Test
    void whatIsLeftOutTakesNoSteps() throws Exception {
        RunFile file = Rov.reader(ColumnMapping.USUAL).between(100, 9_900).read(run);

        assertThat(file.runs().getFirst().duration()).isEqualTo(9_800);
        assertThat(file.notices()).anyMatch(notice -> notice.contains("are these milliseconds?"));
        assertThat(file.doubt()).isEqualTo(Doubt.LASTING);
    }
}
