package org.auvsim.diagnosis.measured;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.report.Report;
import org.auvsim.diagnosis.result.Alternative;
import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.result.Identifiability.Confusion;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/** A pendulum of 0.57 kg that a motor swings up in two ways, and then one of 1 kg. */
@Tag("measured-data")
class PendulumTest {
    private static final String MASS = "mass_error";
    private static final String GAIN = "thruster_gain (motor)";
    private static final String DRY = "coulomb_torque";
    private static final String VISCOUS = "rotational_drag";

    @TempDir private Path report;
    private final DataSet data = DataSet.named("simple-pendulum");

    private Diagnosis diagnosis(Path scenario, double until, String fit, String... heldOut)
            throws Exception {
        BelievedModel model = DataSet.model(scenario, "Pendulum");
        List<Path> toJudge = new ArrayList<>();
        for (String file : heldOut) {
            toJudge.add(data.file(file));
        }
        return data.diagnosis(model, "columns.xml", until, List.of(data.file(fit)), toJudge);
    }

    /**
     * One diagnosis after another, as a user makes them: the friction by two swings of the light
     * pendulum, and what is different with the heavy one by the model that has it.
     */
    @Test
    void frictionIsFoundAndThenTheHeavierMass() throws Exception {
        Diagnosis light =
                diagnosis(data.example("pendulum.xml"), 4, "swingup_energy.csv", "swingup_ddp.csv");

        assertThat(light.verdict()).isEqualTo(Verdict.EXPLAINED);
        assertThat(light.selected()).extracting(Finding::name).contains(DRY, VISCOUS);
        assertThat(error(light.runs().getFirst())).isLessThan(0.009);
        Gain gain = Objects.requireNonNull(light.prediction().gains().get(Channel.ORIENTATION));
        assertThat(gain.before()).isGreaterThan(0.2);
        assertThat(gain.after()).isLessThan(0.03);
        isEitherMassOrGain(light);

        Report.write(light, report);
        Diagnosis heavy =
                diagnosis(report.resolve("extended-scenario.xml"), 8, "swingup_energy_1kg.csv");

        assertThat(heavy.verdict()).isEqualTo(Verdict.EXPLAINED);
        assertThat(heavy.selected()).extracting(Finding::name).containsExactly(MASS);
        assertThat(heavy.selected().getFirst().quantities().getFirst().value())
                .isCloseTo(2, within(0.2));
        Gain gained = Objects.requireNonNull(heavy.prediction().gains().get(Channel.ORIENTATION));
        assertThat(gained.before()).isGreaterThan(0.1);
        assertThat(gained.after()).isLessThan(0.01);
        assertThat(heavy.evidence().identifiability().pairs())
                .anySatisfy(PendulumTest::isOfMassAndGain);
    }

    /** Torque and inertia appear as their ratio alone, whatever friction does to both. */
    private static void isEitherMassOrGain(Diagnosis diagnosis) {
        assertThat(diagnosis.selected()).extracting(Finding::name).containsAnyOf(MASS, GAIN);
        assertThat(diagnosis.evidence().alternatives())
                .filteredOn(Alternative::isIndistinguishable)
                .anySatisfy(other -> assertThat(other.causes()).containsAnyOf(MASS, GAIN));
        assertThat(diagnosis.sentence()).contains("this data cannot tell apart");
        assertThat(diagnosis.evidence().identifiability().pairs())
                .anySatisfy(PendulumTest::isOfMassAndGain);
    }

    private static void isOfMassAndGain(Confusion confusion) {
        assertThat(List.of(confusion.first(), confusion.second()))
                .containsExactlyInAnyOrder(MASS, GAIN);
    }

    /** Root mean square (rad) by which the model with what was found is off a run. */
    private static double error(DiagnosedRun run) {
        double sum = 0;
        for (int k = 0; k < run.run().size(); k++) {
            double w =
                    run.run()
                            .orientation(k)
                            .orElseThrow()
                            .conjugate()
                            .times(run.after().get(k).orientation())
                            .w();
            double angle = 2 * Math.acos(Math.min(1, Math.abs(w)));
            sum += angle * angle;
        }
        return Math.sqrt(sum / run.run().size());
    }
}
