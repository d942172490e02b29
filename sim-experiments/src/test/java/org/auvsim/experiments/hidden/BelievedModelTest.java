package org.auvsim.experiments.hidden;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;

/** Where nothing is hidden, the scenario of a case and the equations of it tell the same motion. */
class BelievedModelTest {
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
    void theSimulatorAgreesWithTheEquations(long seed) {
        HiddenCase of = CaseBook.draw(CaseKind.NULL, 1e-6, seed);
        BelievedModel model = of.model();
        for (int r = 0; r < of.heldOut().size(); r++) {
            MeasuredRun run = of.heldOut().get(r);
            List<RigidMotion> motion =
                    List.of(
                            Ensemble.simulate(
                                    model,
                                    run,
                                    0,
                                    run.size() - 1,
                                    List.of(
                                            new Entrant(
                                                    model.variant(),
                                                    run.start().orElseThrow().motion())))[0]);

            assertThat(of.error(r, motion)).as(of.toString()).isLessThan(2e-4);
        }
    }
}
