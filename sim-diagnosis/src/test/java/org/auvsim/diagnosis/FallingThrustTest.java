package org.auvsim.diagnosis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.actuator.Condition;
import org.auvsim.core.actuator.Propulsor;
import org.auvsim.core.actuator.Sag;
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
import java.util.function.LongFunction;

/** Screws whose thrust is not by what they are told alone. */
@Tag("whole-search")
class FallingThrustTest {
    private static final double LOSS = 0.25;
    private static final double FADE = 0.03;
    private static final double ASTERN = 0.78;
    private static final long SEED = 1;

    /** Thrust goes with the square of the revolutions, and what is lost of it with these. */
    private static double biting(double level, double advance) {
        double revolutions = Math.copySign(Math.sqrt(Math.abs(level)), level);
        double bollard = TwinScrew.THRUST * revolutions * Math.abs(revolutions);
        return bollard - LOSS * TwinScrew.THRUST * Math.abs(revolutions) * advance;
    }

    private static double fading(double level, double time) {
        return TwinScrew.THRUST * (1 - FADE * time) * level;
    }

    private static double weakerAstern(double level) {
        return TwinScrew.THRUST * level * (level < 0 ? ASTERN : 1);
    }

    @Test
    void whatFallsWithSpeedIsNoSumOfDrags() throws Exception {
        Diagnosis of = diagnosis((level, _, advance) -> biting(level, advance));

        double loss = found(of, "thruster_advance", LOSS);
        assertThat(of.sentence()).startsWith("The thrust of all thrusters falls with speed: loss ");
        assertThat(port(of).advanceLoss()).isEqualTo(loss);
    }

    @Test
    void whatFallsWithTimeIsNoGain() throws Exception {
        Diagnosis of = diagnosis((level, time, _) -> fading(level, time));

        double fade = found(of, "thruster_fade", FADE);
        assertThat(of.sentence()).startsWith("The thrust of all thrusters fades: fade ");
        assertThat(port(of).condition().flatMap(Condition::sag)).contains(new Sag(0, fade));
    }

    @Test
    void whatPushesLessAsternIsNoGain() throws Exception {
        TwinScrew.Screw screw = (level, _, _) -> weakerAstern(level);
        Diagnosis of = diagnosis(TwinScrew.SOUND.pushing(screw, screw)::runBothWays);

        double factor = found(of, "thruster_astern", ASTERN);
        assertThat(of.sentence()).startsWith("The thrust of all thrusters astern is wrong: 0.");
        assertThat(port(of).condition().map(Condition::astern)).contains(factor);
    }

    private static Diagnosis diagnosis(TwinScrew.Screw screw) throws Exception {
        return diagnosis(TwinScrew.SOUND.pushing(screw, screw)::run);
    }

    private static Diagnosis diagnosis(LongFunction<MeasuredRun> vehicle) throws Exception {
        BelievedModel model = TwinScrew.model();
        List<MeasuredRun> fit = List.of(vehicle.apply(SEED), vehicle.apply(SEED + 10));
        return new Investigation(
                        model,
                        fit,
                        List.of(vehicle.apply(SEED + 20)),
                        Library.of(model, fit),
                        SEED,
                        Progress.SILENT)
                .diagnose();
    }

    /** The number of a cause that alone is named, and near the true one. */
    private static double found(Diagnosis of, String cause, double truth) {
        assertThat(of.verdict()).as(of.sentence()).isEqualTo(Verdict.EXPLAINED);
        assertThat(of.selected()).extracting(Finding::name).containsExactly(cause);
        Finding found = of.selected().getFirst();
        double number = found.quantities().getFirst().value();
        assertThat(number).isCloseTo(truth, within(3 * found.deviations().getFirst()));
        return number;
    }

    private static Propulsor port(Diagnosis of) {
        return of.extended()
                .world()
                .object("vehicle")
                .component(Propulsor.class, "port")
                .orElseThrow();
    }
}
