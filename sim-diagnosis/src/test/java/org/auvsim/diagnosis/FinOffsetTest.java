package org.auvsim.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.subject.MeasuredTorpedo;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Set;

/** A torpedo whose rudder is built in askew: it turns though it is told to go straight. */
@Tag("whole-search")
class FinOffsetTest {
    private static final double ASKEW = 0.04;

    @Test
    void aRudderWhoseZeroIsOffIsNamed() throws Exception {
        BelievedModel torpedo = MeasuredTorpedo.model(MeasuredTorpedo.RUDDER);
        BelievedModel askew = MeasuredTorpedo.model(MeasuredTorpedo.RUDDER, chord());
        List<MeasuredRun> fit = List.of(run(askew, 1, 0.3), run(askew, 2, -2.2));
        List<Cause> causes =
                Library.of(torpedo, fit).stream()
                        .filter(
                                cause ->
                                        Set.of("fin_offset", "fin_gain", "thruster_gain")
                                                .contains(cause.id()))
                        .toList();

        Diagnosis diagnosis =
                new Investigation(
                                torpedo,
                                fit,
                                List.of(run(askew, 3, 1.9)),
                                causes,
                                1,
                                Progress.SILENT)
                        .diagnose();

        assertThat(diagnosis.sentence()).startsWith("The zero of 'rudder' is off: angle 0.0");
        Finding offset = diagnosis.selected().getFirst();
        assertThat(offset.quantities().getFirst().value()).isCloseTo(ASKEW, within(0.002));
    }

    /** The first 24 s of a run. */
    private static MeasuredRun run(BelievedModel askew, int seed, double heading) {
        return MeasuredTorpedo.run(askew, seed, heading, Vec3.ZERO).stretch(0, 160);
    }

    /** Turned about its span, which points up. */
    private static Vec3 chord() {
        return new Vec3(Math.cos(ASKEW), Math.sin(ASKEW), 0);
    }
}
