package org.auvsim.cli.feed;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;

class LogReaderTest {
    @TempDir private Path folder;

    private MeasuredLog read(String text, Map<String, String> names, LogFrame frame)
            throws IOException, LogException {
        Path file = Files.writeString(folder.resolve("log.csv"), text, UTF_8);
        return new LogReader(file, names, frame).read();
    }

    @Test
    void readsTheUsualColumns() throws Exception {
        assertThat(read("t,x,y,z\n0,1,2,3\n0.5, 4 ,5,6\n", Map.of(), LogFrame.ENU).row())
                .containsExactly(
                        new MeasuredLog.Row(0, new Vec3(1, 2, 3)),
                        new MeasuredLog.Row(0.5, new Vec3(4, 5, 6)));
    }

    @Test
    void heightsThatAreNotThereAreZero() throws Exception {
        assertThat(read("y,x,t\n2,1,0\n", Map.of(), LogFrame.ENU).row())
                .containsExactly(new MeasuredLog.Row(0, new Vec3(1, 2, 0)));
    }

    @Test
    void northEastDownBecomesEastNorthUp() throws Exception {
        String text = "\uFEFFtime,n,e,d\n1,10,20,30\n";
        Map<String, String> names = Map.of("t", "time", "x", "n", "y", "e", "z", "d");
        assertThat(read(text, names, LogFrame.NED).row())
                .containsExactly(new MeasuredLog.Row(1, new Vec3(20, 10, -30)));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "t,x,y;0,1,2;1,a,2 | :3: column 'x': expected a number, but found 'a'.",
                "t,x,y;0,1,NaN | :2: column 'y': expected a number, but found 'NaN'.",
                "t,x,y;0,1,2;0,1,2 | :3: column 't': expected a time after 0.0 s, but found '0'.",
                "t,x,y | ' has no rows: expected a header line and rows below it.'",
                "t,x;0,1 | ':1: there is no column ''y'', only t, x; say with --columns which to"
                        + " take.'",
            })
    void whatIsWrongHasItsPlace(String text, String sentence) {
        assertThatThrownBy(() -> read(text.replace(';', '\n'), Map.of(), LogFrame.ENU))
                .isInstanceOf(LogException.class)
                .hasMessage(folder.resolve("log.csv") + sentence);
    }

    @Test
    void aRowThatIsTooShortIsToldWithItsLine() {
        assertThatThrownBy(() -> read("t,x,y\n0,1,2\n1,5\n", Map.of(), LogFrame.ENU))
                .isInstanceOf(LogException.class)
                .hasMessageContaining("log.csv")
                .hasMessageContaining("3");
    }
}
