package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.subject.Surveyor;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/** A vehicle whose positions come late, as those of a receiver; its heading does not. */
@Tag("whole-search")
class LatePositionsTest {
    private static final int ROWS = 8;

    /** The model is right, but for when positions are told. */
    private static MeasuredRun run(long seed) {
        MeasuredRun of = new Surveyor(0, Vec3.ZERO, 1, 0).run("run " + seed, new Random(seed));
        Vec3 nowhere = new Vec3(Double.NaN, Double.NaN, Double.NaN);
        return Surveyor.told(
                of,
                k -> k < ROWS ? nowhere : of.vector(Channel.POSITION, k - ROWS).orElseThrow(),
                k -> of.orientation(k).orElseThrow());
    }

    @Test
    void areToldFromAllElse() throws Exception {
        BelievedModel model = Surveyor.believed();
        List<MeasuredRun> fit = List.of(run(1), run(2));
        List<String> some =
                List.of(
                        "quadratic_drag",
                        "current_constant",
                        "thruster_gain",
                        "thruster_lag",
                        "sensor_bias",
                        "sensor_delay",
                        "sensor_scale",
                        "position_drift",
                        "sensor_lever_arm",
                        "position_delay");

        Diagnosis diagnosis =
                new Investigation(
                                model,
                                fit,
                                List.of(run(3)),
                                Library.named(some, Library.of(model, fit)),
                                1,
                                Progress.SILENT)
                        .diagnose();

        assertThat(diagnosis.sentence()).startsWith("The measured positions are late: ");
        assertThat(diagnosis.selected())
                .extracting(Finding::cause)
                .containsExactly("position_delay");
        double spacing = fit.getFirst().time(1) - fit.getFirst().time(0);
        assertThat(diagnosis.selected().getFirst().quantities().getFirst().value())
                .isCloseTo(ROWS * spacing, within(0.02));
    }
}
