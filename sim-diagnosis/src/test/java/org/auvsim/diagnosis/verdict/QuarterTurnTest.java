package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.subject.MeasuredVehicle;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;

class QuarterTurnTest {
    private static Cause turned(BelievedModel model, List<MeasuredRun> runs) {
        return Library.named(List.of("axis_misalignment"), Library.of(model, runs)).getFirst();
    }

    private static Optional<String> notice(double... turn) throws Exception {
        BelievedModel model = MeasuredVehicle.model(0.05);
        Cause turned = turned(model, List.of(MeasuredVehicle.run(model)));
        return QuarterTurn.notice(Hypothesis.NONE.and(turned, turn));
    }

    @Test
    void axesThatAreTurnedByAQuarterMayBeOthers() throws Exception {
        assertThat(notice(1.569, 0.02, -0.01).orElseThrow())
                .startsWith("the measured positions were found to be turned by 1.57 rad, about a")
                .contains("--ned");
        assertThat(notice(0, 2.2, 2.2).orElseThrow()).contains("about half a turn");
    }

    @Test
    void aSensorMayBeMountedAskew() throws Exception {
        assertThat(notice(0.02, 0.01, -0.03)).isEmpty();
        assertThat(notice(0, 0, 0.8)).isEmpty();
    }
}
