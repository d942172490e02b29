package org.auvsim.diagnosis.measured;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Alternative;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Objects;

/**
 * A pendulum of 0.57 kg, and one of 1 kg, that a motor swings up: of each, the first 4 s are
 * fitted, and the next 4 s held out.
 */
@Tag("measured-data")
class PendulumTest {
    private static final int ROWS = 800;
    private static final String MASS = "mass_error";
    private static final String GAIN = "thruster_gain (motor)";
    private static final String LAG = "thruster_lag";

    private final DataSet data = DataSet.named("simple-pendulum");

    private Diagnosis diagnosis(String file) throws Exception {
        BelievedModel model = data.model("pendulum.xml", "Pendulum");
        MeasuredRun run = data.run(model, "columns.xml", file);
        return DataSet.diagnosis(
                model,
                List.of(run.part("first", 0, ROWS)),
                List.of(run.part("second", ROWS, 2 * ROWS)));
    }

    /** Torque and inertia appear as their ratio alone: one of the two is not what is believed. */
    @Test
    void theHeavyPendulumIsFoundAndMassIsToldFromTorqueByNobody() throws Exception {
        Diagnosis heavy = diagnosis("swingup_energy_1kg.csv");

        assertThat(heavy.verdict()).isEqualTo(Verdict.EXPLAINED);
        assertThat(heavy.selected()).extracting(f -> f.name()).isSubsetOf(GAIN, MASS, LAG);
        assertThat(heavy.alternatives())
                .filteredOn(Alternative::isIndistinguishable)
                .anySatisfy(other -> assertThat(other.causes()).containsAnyOf(MASS, GAIN));
        assertThat(heavy.sentence()).contains("this data cannot tell apart");
        Gain gain = Objects.requireNonNull(heavy.heldOut().get(Channel.ORIENTATION));
        assertThat(gain.before()).isGreaterThan(0.9);
        assertThat(gain.after()).isLessThan(0.06);

        double ratio = mass(heavy) / mass(diagnosis("swingup_energy.csv"));
        assertThat(ratio).isBetween(1.6, 2.1);
    }

    /** Times the believed mass, if it is the mass, and the motor follows late. */
    private static double mass(Diagnosis diagnosis) {
        return diagnosis.ranked().stream()
                .filter(set -> set.causes().equals(List.of(MASS, LAG)))
                .findFirst()
                .orElseThrow()
                .quantities()
                .getFirst()
                .getFirst()
                .value();
    }
}
