package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.residual.Outcome;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.search.Alternatives;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.subject.MeasuredVehicle;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

import java.util.List;

/** Of two causes that predict the same the common one is believed, unless the other fits better. */
class CommonestTest {
    private static Fit believed;
    private static Outcome outcome;
    private static List<Cause> library;

    @BeforeAll
    static void aVehicleIsMeasured() throws Exception {
        BelievedModel model = MeasuredVehicle.model(0.05);
        List<MeasuredRun> runs = List.of(MeasuredVehicle.run(model));
        Noise noise = Noise.of(runs);
        believed =
                Following.of(Stepping.exact(model), Hypothesis.NONE, Misses.of(runs, noise), noise)
                        .whole();
        outcome = believed.outcome();
        library = Library.of(model, runs);
    }

    /** A cause of one number with this misfit, which predicts what the others do. */
    private static Judged judged(String id, double misfit) {
        Cause cause = library.stream().filter(of -> of.id().equals(id)).findFirst().orElseThrow();
        Hypothesis of = Hypothesis.NONE.and(cause, new double[] {1.1});
        Judged free = new Judged(believed.with(of, believed.windows()), outcome, of.size(), 0);
        return free.dearer(free.price() + misfit);
    }

    private static Judged commonest(Judged best, Judged other) {
        return Alternatives.commonest(best, List.of(other), library);
    }

    @Test
    void theCommonOneIsBelievedWhereNothingSpeaksForTheOther() {
        Judged weight = judged("buoyancy_weight", 101.9);
        Judged mass = judged("mass_error", 100);

        assertThat(commonest(mass, weight)).isSameAs(weight);
        assertThat(commonest(weight, mass)).isSameAs(weight);
    }

    @Test
    void theOtherIsBelievedWhereItFitsBetter() {
        Judged weight = judged("buoyancy_weight", 102.1);
        Judged mass = judged("mass_error", 100);

        assertThat(commonest(mass, weight)).isSameAs(mass);
    }
}
