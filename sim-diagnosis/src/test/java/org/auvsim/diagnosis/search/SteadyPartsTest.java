package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;
import java.util.Set;

/**
 * A pole on a pivot, which a jet at its end moves to and fro: upright, where only the jet keeps it
 * from falling, or hanging. The jet is weaker than its model.
 */
class SteadyPartsTest {
    private static final double GRAVITY = 9.80665;
    private static final double MASS = 2;
    private static final double INERTIA = 0.5;
    private static final double THRUST = 10;
    private static final double GAIN = 0.8;
    private static final double SPACING = 0.05;
    private static final int SAMPLES = 201;
    private static final int SUBSTEPS = 500;
    private static final double NOISE = 0.003;
    private static final double UPRIGHT = 0.1;
    private static final double HANGING = -0.1;
    private static final Set<String> IDS =
            Set.of("rotational_drag", "thruster_gain", "mass_error", "step_force");

    /** Errors of what falls grow by e^(1.94 t), 2.6e8-fold in 10 s; less where it leans. */
    @Test
    void whatFallsIsTakenInParts() throws Exception {
        SteadyParts parts =
                SteadyParts.of(model(UPRIGHT, THRUST), List.of(run(UPRIGHT, 1)), Course.UNHEARD);

        assertThat(parts.runs()).hasSize(4).allMatch(MeasuredRun::isPart);
        assertThat(parts.notices())
                .singleElement()
                .asString()
                .startsWith("run1: an error of its start grows more than 1000000-fold over it, ")
                .endsWith("in 4 parts of 2.5 s, each with a start of its own");
    }

    @Test
    void whatHangsIsFollowedInOneGo() throws Exception {
        List<MeasuredRun> runs = List.of(run(HANGING, 1), run(HANGING, 2));

        SteadyParts parts = SteadyParts.of(model(HANGING, THRUST), runs, Course.UNHEARD);

        assertThat(parts.runs()).isEqualTo(runs);
        assertThat(parts.notices()).isEmpty();
    }

    @Test
    void whatWasCutIsNotCutAgain() throws Exception {
        List<MeasuredRun> halves = run(UPRIGHT, 1).parts(2);

        assertThat(SteadyParts.of(model(UPRIGHT, THRUST), halves, Course.UNHEARD).runs())
                .isEqualTo(halves);
    }

    @Test
    void theCauseIsFoundInParts() throws Exception {
        Diagnosis diagnosis = diagnosis(THRUST);

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.EXPLAINED);
        assertThat(diagnosis.selected())
                .extracting(Finding::name)
                .containsExactly("thruster_gain (jet)");
        assertThat(diagnosis.notices()).filteredOn(n -> n.contains("in 4 parts")).hasSize(3);
    }

    @Test
    void aModelThatLacksNothingLacksNothingInParts() throws Exception {
        assertThat(diagnosis(GAIN * THRUST).verdict()).isEqualTo(Verdict.NONE);
    }

    private static Diagnosis diagnosis(double thrust) throws Exception {
        BelievedModel model = model(UPRIGHT, thrust);
        List<MeasuredRun> fit = List.of(run(UPRIGHT, 1), run(UPRIGHT, 2));
        List<MeasuredRun> heldOut = List.of(run(UPRIGHT, 3));
        List<Cause> causes =
                Library.of(model, fit).stream().filter(c -> IDS.contains(c.id())).toList();
        return new Investigation(model, fit, heldOut, causes, 1, Progress.SILENT).diagnose();
    }

    private static BelievedModel model(double centre, double thrust) throws Exception {
        return Believed.model(
                """
                <scenario><time-step delta="0.05"/>
                  <world-object name="Pole" mass="2">
                    <box><size x="0.1" y="0.1" z="2"/></box>
                    <inertia xx="0.5" yy="0.5" zz="0.1"/>
                    <centre-of-mass x="0" y="0" z="%s"/>
                    <pinned><axis x="0" y="1" z="0"/></pinned><gravity/>
                    <propulsor name="jet" maximum-thrust="%s">
                      <position x="0" y="0" z="1"/></propulsor>
                  </world-object>
                </scenario>
                """
                        .formatted(centre, thrust),
                "Pole");
    }

    /** I a = m g l sin(angle) + jet, which is told anew in each row by how the pole stands. */
    private static MeasuredRun run(double centre, long seed) {
        Random random = new Random(seed);
        double inertia = INERTIA + MASS * centre * centre;
        MeasuredRunBuilder run = MeasuredRun.named("run" + seed).commands(List.of("jet"));
        double angle = 0.1 * random.nextGaussian();
        double rate = 0;
        for (int k = 0; k < SAMPLES; k++) {
            double wanted = 0.3 * Math.sin(0.8 * k * SPACING + seed);
            double level = Math.clamp(-0.8 * (angle - wanted) - 0.4 * rate, -1, 1);
            double told = angle + NOISE * random.nextGaussian();
            run.at(k * SPACING)
                    .command(0, level)
                    .orientation(Quat.ofAxisAngle(new Vec3(0, 1, 0), told), false, true, false);
            double h = SPACING / SUBSTEPS;
            for (int s = 0; s < SUBSTEPS; s++) {
                double middle = angle + h / 2 * rate;
                double torque = MASS * GRAVITY * centre * Math.sin(middle) + GAIN * THRUST * level;
                rate += h * torque / inertia;
                angle = middle + h / 2 * rate;
            }
        }
        return run.build();
    }
}
