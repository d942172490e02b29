package org.auvsim.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.actuator.Propulsor;
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

/** Screws that bite less, the faster the vehicle goes. */
@Tag("whole-search")
class FallingThrustTest {
    private static final double LOSS = 0.25;

    /** Thrust goes with the square of the revolutions, and what is lost of it with these. */
    private static double thrust(double level, double advance) {
        double revolutions = Math.copySign(Math.sqrt(Math.abs(level)), level);
        double bollard = TwinScrew.THRUST * revolutions * Math.abs(revolutions);
        return bollard - LOSS * TwinScrew.THRUST * Math.abs(revolutions) * advance;
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2})
    void isNamedAndNotASumOfDrags(long seed) throws Exception {
        TwinScrew vehicle = new TwinScrew(FallingThrustTest::thrust, FallingThrustTest::thrust);
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
        assertThat(of.selected()).extracting(Finding::name).containsExactly("thruster_advance");
        Finding found = of.selected().getFirst();
        assertThat(found.quantities().getFirst().value())
                .isCloseTo(LOSS, within(3 * found.deviations().getFirst()));
        assertThat(of.sentence()).startsWith("The thrust of all thrusters falls with speed: loss ");
        Propulsor port =
                of.extended()
                        .world()
                        .object("vehicle")
                        .component(Propulsor.class, "port")
                        .orElseThrow();
        assertThat(port.advanceLoss()).isEqualTo(found.quantities().getFirst().value());
    }
}
