package org.auvsim.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.world.World;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;

/** Of two thrusters side by side one is wired backwards. */
@Tag("whole-search")
class ReversedThrusterTest {
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2})
    void isFound(long seed) throws Exception {
        TwinScrew vehicle =
                TwinScrew.SOUND.pushing(
                        (level, _, _) -> -TwinScrew.THRUST * level, TwinScrew.SOUND.starboard());
        BelievedModel model = TwinScrew.model();
        List<MeasuredRun> fit = List.of(vehicle.run(seed), vehicle.run(seed + 10));

        Diagnosis of =
                new Investigation(
                                model,
                                fit,
                                List.of(vehicle.run(seed + 20)),
                                Library.of(model, fit),
                                seed,
                                Progress.SILENT)
                        .diagnose();

        assertThat(of.verdict()).as(of.sentence()).isEqualTo(Verdict.EXPLAINED);
        assertThat(of.selected()).extracting(Finding::name).containsExactly("thruster_gain (port)");
        assertThat(of.selected().getFirst().quantities().getFirst().value())
                .isCloseTo(-1, within(0.02));
        assertThat(of.sentence()).startsWith("'port' runs backwards: ");
        World served = of.extended().world();
        assertThat(
                        served.object("vehicle")
                                .component(Propulsor.class, "port")
                                .orElseThrow()
                                .commanded(0.5, 0)
                                .thrustAt(0))
                .isCloseTo(-TwinScrew.THRUST / 2, within(0.2));
    }
}
