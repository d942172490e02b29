package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.Collections;
import java.util.List;

/** Which runs can judge one another. */
class LeaveOneOutTest {
    private static final MeasuredRun UNKNOWN = run().build();
    private static final MeasuredRun KNOWN =
            run().start(
                            new KnownStart(
                                    new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO),
                                    Collections.nCopies(RigidMotion.SIZE, 0.01)))
                    .build();

    private static MeasuredRunBuilder run() {
        MeasuredRunBuilder run = MeasuredRun.named("run");
        for (int k = 0; k < 400; k++) {
            run.at(0.1 * k).position(0.1 * k, 0, 0);
        }
        return run;
    }

    private static List<MeasuredRun> halves(MeasuredRun run) {
        return List.of(run.part("first", 0, 150), run.part("second", 151, 300));
    }

    @Test
    void partsOfARunCanUnlessTheFirstAloneHasAKnownStart() {
        assertThat(LeaveOneOut.canJudge(halves(UNKNOWN))).isTrue();
        assertThat(LeaveOneOut.canJudge(List.of(KNOWN, UNKNOWN))).isTrue();
        assertThat(LeaveOneOut.canJudge(halves(KNOWN.stretch(0, 350)))).isFalse();
    }

    /** The known start is before all of them. */
    @Test
    void partsOfALaterStretchCan() {
        MeasuredRun later = KNOWN.stretch(50, 399);

        assertThat(later.start()).isEmpty();
        assertThat(LeaveOneOut.canJudge(halves(later))).isTrue();
    }
}
