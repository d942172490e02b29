package org.auvsim.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;

/** A compass that was built in beside a battery. */
@Tag("whole-search")
class CompassDeviationTest {
    private static final double SINE = 0.12;
    private static final double COSINE = -0.07;

    @Test
    void isNoHeadingThatIsOffByAConstant() throws Exception {
        TwinScrew vehicle =
                TwinScrew.SOUND.steering(
                        heading -> heading + SINE * Math.sin(heading) + COSINE * Math.cos(heading));
        BelievedModel model = TwinScrew.model();
        List<MeasuredRun> fit = List.of(vehicle.run(1), vehicle.run(11));

        Diagnosis of =
                new Investigation(
                                model,
                                fit,
                                List.of(vehicle.run(21)),
                                Library.of(model, fit),
                                1,
                                Progress.SILENT)
                        .diagnose();

        assertThat(of.verdict()).as(of.sentence()).isEqualTo(Verdict.EXPLAINED);
        assertThat(of.selected()).extracting(Finding::name).containsExactly("compass_deviation");
        Finding found = of.selected().getFirst();
        assertThat(found.quantities().get(0).value())
                .isCloseTo(SINE, within(3 * found.deviations().get(0)));
        assertThat(found.quantities().get(1).value())
                .isCloseTo(COSINE, within(3 * found.deviations().get(1)));
        assertThat(of.sentence()).startsWith("The compass has a deviation: ");
    }
}
