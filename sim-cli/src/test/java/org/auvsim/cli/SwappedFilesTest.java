package org.auvsim.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Path;

/** What is given as a scenario and is none. */
class SwappedFilesTest {
    private static final String LIKE_CSV = "this looks like CSV";

    @TempDir private Path folder;
    private CommandLineHarness auvsim;

    @BeforeEach
    void begin() {
        auvsim = new CommandLineHarness(folder);
    }

    private int diagnose(String scenario) throws IOException {
        Path run = auvsim.file("run.csv", "t,x\n0,1\n");
        return auvsim.run(
                "diagnose", "--scenario", auvsim.file("model.xml", scenario), "--fit", run);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "t,x,y",
                "x;t;yaw",
                "time_ms,GPS_North,GPS_East",
                "unix_time\tdepth",
                "\"Time [s]\", \"x\"",
                "Timestamp,lat,lon"
            })
    void aHeaderWithATimeLooksLikeCsv(String header) throws IOException {
        assertThat(diagnose(header + "\n0,1,2\n")).isEqualTo(2);
        assertThat(auvsim.err()).contains(LIKE_CSV);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "This is a note, not a scenario",
                "Next time, perhaps; or never",
                "{\"mass\": 3, \"name\": 4}",
                "mass: 30, 40"
            })
    void anotherTextWithCommasDoesNot(String text) throws IOException {
        assertThat(diagnose(text + "\n")).isEqualTo(2);
        assertThat(auvsim.err()).doesNotContain(LIKE_CSV).contains("model.xml:1:1: ");
    }

    @Test
    void norDoesAScenarioThatIsBroken() throws IOException {
        assertThat(diagnose("<scenario t, time>")).isEqualTo(2);
        assertThat(auvsim.err()).doesNotContain(LIKE_CSV).contains("model.xml:1:");
    }
}
