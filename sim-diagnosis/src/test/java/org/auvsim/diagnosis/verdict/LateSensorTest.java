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
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.List;
import java.util.Random;

/** A vehicle of whose sensors one is late: a receiver, whose heading is not, or a compass. */
@Tag("whole-search")
class LateSensorTest {
    private static final int ROWS = 8;
    private static final Vec3 NOWHERE = new Vec3(Double.NaN, Double.NaN, Double.NaN);

    /** The model is right, but for when that is told. */
    private static MeasuredRun run(long seed, Channel late) {
        MeasuredRun of = new Surveyor(0, Vec3.ZERO, 1, 0).run("run " + seed, new Random(seed));
        int oldPlace = late == Channel.POSITION ? ROWS : 0;
        int oldTurn = late == Channel.ORIENTATION ? ROWS : 0;
        return Surveyor.told(
                of,
                k -> k < ROWS ? NOWHERE : of.vector(Channel.POSITION, k - oldPlace).orElseThrow(),
                k -> of.orientation(Math.max(0, k - oldTurn)).orElseThrow());
    }

    @ParameterizedTest
    @CsvSource({
        "POSITION, position_delay, The measured positions are late: ",
        "ORIENTATION, orientation_delay, The measured orientations are late: "
    })
    void isToldFromAllElse(Channel late, String cause, String sentence) throws Exception {
        BelievedModel model = Surveyor.believed();
        List<MeasuredRun> fit = List.of(run(1, late), run(2, late));
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
                        "position_delay",
                        "orientation_delay");

        Diagnosis diagnosis =
                new Investigation(
                                model,
                                fit,
                                List.of(run(3, late)),
                                Library.named(some, Library.of(model, fit)),
                                1,
                                Progress.SILENT)
                        .diagnose();

        assertThat(diagnosis.sentence()).startsWith(sentence);
        assertThat(diagnosis.selected()).extracting(Finding::cause).containsExactly(cause);
        double spacing = fit.getFirst().time(1) - fit.getFirst().time(0);
        assertThat(diagnosis.selected().getFirst().quantities().getFirst().value())
                .isCloseTo(ROWS * spacing, within(0.02));
    }
}
