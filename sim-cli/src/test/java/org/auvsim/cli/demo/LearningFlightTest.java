package org.auvsim.cli.demo;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.auvsml.message.learning.FoundCause;
import org.auvsim.auvsml.message.learning.ModelCorrectionNotification;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;

/** The demonstration's last act, as the user gets it. */
@Timeout(600)
class LearningFlightTest {
    private static final Path SCENARIO = Path.of("..", "examples", "scenarios", "demo.xml");

    /** Root mean square of three coordinates' noise of 5 mm. */
    private static final double NOISE = 0.005 * Math.sqrt(3);

    @Test
    void theServerNamesWhatItsModelLacksAndThenFollowsTheRobotWithinItsNoise() throws Exception {
        Track track = new Track("learning");
        LiveTable table = new LiveTable(new PrintWriter(new StringWriter()));
        ClassLoader loader = LearningFlightTest.class.getClassLoader();

        ModelCorrectionNotification learned =
                new LearningFlight(ScenarioLoader.load(loader).load(SCENARIO), track, table)
                        .fly()
                        .orElseThrow();

        assertThat(learned.modelCorrection().cause())
                .as(learned.modelCorrection().sentence())
                .extracting(FoundCause::name)
                .containsExactlyInAnyOrder(
                        "anisotropic_drag", "rotational_drag", "current_constant");
        double before = track.part("before", 0, learned.timestamp()).rmsError();
        double after = track.part("after", learned.timestamp(), Double.MAX_VALUE).rmsError();
        assertThat(after).isLessThan(NOISE).isLessThan(before / 2);
    }
}
