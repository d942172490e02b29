package org.auvsim.diagnosis.reading;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.run.ColumnMapping;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** A vehicle goes round and round: its heading counts its turns, and no model minds. */
class SettledSuspicionsTest {
    private static final String QUESTION = "are they in degrees";

    @TempDir private Path folder;

    private RunFiles files(String header) throws Exception {
        Path run =
                Rov.write(
                        folder.resolve("run.csv"),
                        Rov.rows(header, 60, i -> 3 * i + "," + i % 2 * 30 + ",0.5,0"));
        return RunFiles.read(Rov.reader(ColumnMapping.USUAL), List.of(run), List.of());
    }

    @ParameterizedTest
    @EnumSource(
            value = Verdict.class,
            names = {"EXPLAINED", "NONE"})
    void whatAModelExplainsIsSettled(Verdict verdict) throws Exception {
        RunFiles files = files("yaw,r,main,rudder");

        assertThat(files.notices()).filteredOn(notice -> notice.contains(QUESTION)).hasSize(2);
        assertThat(files.noticesAfter(verdict, Map.of()))
                .hasSameSizeAs(files.notices())
                .noneMatch(notice -> notice.contains(QUESTION))
                .contains(
                        folder.resolve("run.csv")
                                + ":61: column 'yaw': angles go up to 177 rad, and the model"
                                + " explains them so: they are in radians",
                        folder.resolve("run.csv")
                                + ":2: column 'r': p, q, r differ by up to 30 rad/s, and the model"
                                + " explains them so: they are in radians");
    }

    @ParameterizedTest
    @EnumSource(
            value = Verdict.class,
            names = {"UNEXPLAINED", "UNDECIDED"})
    void whatNothingExplainsStaysSuspected(Verdict verdict) throws Exception {
        RunFiles files = files("yaw,r,main,rudder");

        assertThat(files.noticesAfter(verdict, Map.of())).isEqualTo(files.notices());
    }

    /** Headings in degrees that were taken for radians are noise all around, which hides all. */
    @Test
    void anglesWithErrorsAsLargeAsAnglesCanBeStaySuspected() throws Exception {
        RunFiles files = files("yaw,r,main,rudder");
        Map<Channel, Double> errors = Map.of(Channel.ORIENTATION, 1.4);

        assertThat(files.doubt().isOpen(Verdict.NONE, errors)).isTrue();
        assertThat(files.noticesAfter(Verdict.NONE, errors)).isEqualTo(files.notices());
    }

    /** Nothing drives it: what looks explained may be something else. */
    @Test
    void besideAGraverDoubtItStaysSuspected() throws Exception {
        RunFiles files = files("yaw,r,push.x,rudder");

        assertThat(files.doubt()).isEqualTo(Doubt.LASTING);
        assertThat(files.noticesAfter(Verdict.NONE, Map.of())).isEqualTo(files.notices());
    }
}
