package org.auvsim.experiments.hidden;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Ensemble.Entrant;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.List;

/**
 * Each cause of the library, given the true numbers, makes of the believed model what independent
 * equations tell: that it means what it says, units, axes, signs and all.
 */
class LibraryTest {
    /** Of what the effect changes on held-out runs, this may be left. */
    private static final double MOST_LEFT = 0.01;

    @ParameterizedTest(name = "{1}, seed {0}")
    @CsvSource({
        "104, added_mass",
        "30, anisotropic_drag",
        "12, axis_misalignment",
        "20, buoyancy_weight",
        "61, cob_offset",
        "71, coulomb_friction",
        "70, current_constant",
        "66, current_constant",
        "89, current_oscillating",
        "46, current_shear",
        "36, current_vortex",
        "18, impulse",
        "51, inertia_error",
        "37, linear_drag",
        "21, magnetic",
        "40, magnus",
        "117, mass_error",
        "14, periodic_force",
        "11, quadratic_drag",
        "17, rotational_drag",
        "16, sensor_bias",
        "32, sensor_delay",
        "60, sensor_drift",
        "45, sensor_scale",
        "7, step_force",
        "103, tether_spring",
        "129, thruster_deadzone",
        "119, thruster_gain",
        "28, thruster_lag",
        "58, thruster_loss",
        "22, thruster_misalignment",
        "65, wave_forcing"
    })
    void aCauseWithTheTrueNumbersTellsTheTruth(long seed, String id) {
        HiddenCase of = CaseBook.draw(CaseKind.SINGLE, 1e-6, seed);
        HiddenEffect hidden = of.hidden().getFirst();
        assertThat(hidden.cause()).isEqualTo(id);
        BelievedModel model = of.model();
        Cause cause = cause(of, hidden);
        Variant variant = cause.in(model.variant(), TrueNumbers.of(cause, hidden));

        double before = 0;
        double after = 0;
        for (int r = 0; r < of.heldOut().size(); r++) {
            before += Math.pow(of.error(r, told(of, r, model.variant())), 2);
            after += Math.pow(of.error(r, told(of, r, variant)), 2);
        }
        assertThat(Math.sqrt(after / before)).as(of.toString()).isLessThan(MOST_LEFT);
    }

    private static Cause cause(HiddenCase of, HiddenEffect hidden) {
        boolean isOnlyThruster = of.scene().plant().thrusters().size() == 1;
        return Library.of(of.model(), of.fit()).stream()
                .filter(c -> c.id().equals(hidden.cause()))
                .filter(c -> c.subject().equals(hidden.subject()) || isOnlyThruster)
                .filter(c -> TrueNumbers.haveAPlaceIn(c, hidden))
                .findFirst()
                .orElseThrow();
    }

    private static List<RigidMotion> told(HiddenCase of, int r, Variant variant) {
        MeasuredRun run = of.heldOut().get(r);
        RigidMotion[] motion =
                Ensemble.simulate(
                        of.model(),
                        run,
                        0,
                        run.size() - 1,
                        List.of(new Entrant(variant, run.start().orElseThrow().motion())))[0];
        return List.of(variant.sensing().of(motion, run, 0, motion.length));
    }
}
