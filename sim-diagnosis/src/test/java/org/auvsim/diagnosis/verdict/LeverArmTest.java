package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.cause.Quantity;
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
import java.util.function.IntFunction;

/** A receiver tells where its antenna is, which is not the body's origin. */
@Tag("whole-search")
class LeverArmTest {
    private static final Vec3 ARM = new Vec3(0.7, -0.2, 0.4);

    /** The model is right, but for what the positions are of. */
    private static MeasuredRun run(long seed) {
        MeasuredRun of = new Surveyor(0, Vec3.ZERO, 1, 0).run("run " + seed, new Random(seed));
        IntFunction<Quat> heading = k -> of.orientation(k).orElseThrow();
        return Surveyor.told(
                of,
                k ->
                        of.vector(Channel.POSITION, k)
                                .orElseThrow()
                                .plus(heading.apply(k).rotate(ARM)),
                heading);
    }

    @Test
    void isFoundAmongOthers() throws Exception {
        BelievedModel model = Surveyor.believed();
        List<MeasuredRun> fit = List.of(run(1), run(2));
        List<String> some =
                List.of(
                        "quadratic_drag",
                        "rotational_drag",
                        "current_constant",
                        "thruster_gain",
                        "thruster_lag",
                        "cob_offset",
                        "sensor_bias",
                        "sensor_delay",
                        "position_drift",
                        "sensor_lever_arm");

        Diagnosis diagnosis =
                new Investigation(
                                model,
                                fit,
                                List.of(run(3)),
                                Library.named(some, Library.of(model, fit)),
                                1,
                                Progress.SILENT)
                        .diagnose();

        assertThat(diagnosis.sentence())
                .startsWith("The measured positions are of another point of the body: (0.7")
                .contains("not determined) m");
        assertThat(diagnosis.selected())
                .extracting(Finding::cause)
                .containsExactly("sensor_lever_arm");
        List<Quantity> arm = diagnosis.selected().getFirst().quantities();
        assertThat(arm.get(0).value()).isCloseTo(ARM.x(), within(0.005));
        assertThat(arm.get(1).value()).isCloseTo(ARM.y(), within(0.005));
    }
}
