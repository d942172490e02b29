package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.function.LongFunction;

/**
 * Thrown balls whose spin is stated, but not exactly, and whose model lacks the Magnus force. Only
 * the product of its coefficient and the spin shows: the spin's doubt is the coefficient's.
 */
class SpinningBallTest {
    private static final double MASS = 0.145;
    private static final double COEFFICIENT = 2.2e-4;
    private static final double GRAVITY = 9.80665;
    private static final double SPIN = 150;
    private static final double DOUBT = 6;
    private static final double NOISE = 0.005;
    private static final double SPACING = 1 / 64.0;
    private static final int SAMPLES = 80;
    private static final int SUBSTEPS = 200;
    private static final Set<String> IDS =
            Set.of("magnus", "linear_drag", "step_force", "current_vortex");

    @Test
    void theCoefficientIsAsDoubtfulAsTheSpin() throws Exception {
        Diagnosis diagnosis = diagnosis("", SpinningBallTest::run);

        assertThat(diagnosis.selected()).extracting(Finding::cause).containsExactly("magnus");
        Finding magnus = diagnosis.selected().getFirst();
        double deviation = magnus.deviations().getFirst();
        double ofSpins = DOUBT / SPIN / Math.sqrt(3) * COEFFICIENT;
        assertThat(deviation).isBetween(0.8 * ofSpins, 1.5 * ofSpins);
        assertThat(magnus.quantities().getFirst().value())
                .isCloseTo(COEFFICIENT, within(3 * deviation));
        assertThat(diagnosis.notices()).noneMatch(notice -> notice.contains("spin"));
    }

    /** Of a spin that nobody told only its product with the coefficient shows. */
    @Test
    void ofAnUnseenSpinTheProductIsTold() throws Exception {
        Diagnosis diagnosis = diagnosis("", seed -> thrown(seed, along(seed).times(SPIN)).build());

        assertThat(diagnosis.selected()).extracting(Finding::cause).containsExactly("magnus");
        Finding magnus = diagnosis.selected().getFirst();
        double size = COEFFICIENT * SPIN;
        assertThat(magnus.deviations().getFirst()).isLessThan(0.02 * size);
        assertThat(magnus.quantities().getFirst().value()).isCloseTo(size, within(0.02 * size));
        assertThat(diagnosis.notices()).anyMatch(n -> n.startsWith("nothing tells how the body"));
    }

    @Test
    void aSpinThatOnlyTheScenarioTellsIsTaken() throws Exception {
        Vec3 spin = new Vec3(0, 0, SPIN);
        Diagnosis diagnosis =
                diagnosis(
                        "<angular-velocity x='0' y='0' z='150'/>",
                        seed -> thrown(seed, spin).build());

        assertThat(diagnosis.selected()).extracting(Finding::cause).containsExactly("magnus");
        assertThat(diagnosis.selected().getFirst().quantities().getFirst().value())
                .isCloseTo(COEFFICIENT, within(0.3 * COEFFICIENT));
        assertThat(diagnosis.notices()).anyMatch(n -> n.contains("but the scenario"));
    }

    /**
     * Of three runs and one that judges.
     *
     * @param spin as the scenario states it
     */
    private static Diagnosis diagnosis(String spin, LongFunction<MeasuredRun> run)
            throws Exception {
        BelievedModel model =
                Believed.model(
                        """
                        <scenario><time-step delta="0.004"/>
                          <world-object name="ball" mass="0.145"><sphere radius="0.037"/>
                            <position x="0" y="0" z="1.5"/>%s<gravity/></world-object>
                        </scenario>
                        """
                                .formatted(spin),
                        "ball");
        List<MeasuredRun> fit = List.of(run.apply(1), run.apply(2), run.apply(3));
        List<Cause> causes =
                Library.of(model, fit).stream().filter(c -> IDS.contains(c.id())).toList();
        return new Investigation(model, fit, List.of(run.apply(4)), causes, 1, Progress.SILENT)
                .diagnose();
    }

    private static MeasuredRun run(long seed) {
        Vec3 spin = along(seed).times(SPIN);
        Vec3 stated = spin.times(1 + DOUBT / SPIN * new Random(seed).nextGaussian());
        return thrown(seed, spin).start(known(stated)).build();
    }

    private static Vec3 along(long seed) {
        Random random = new Random(2 * seed);
        return new Vec3(0.2, random.nextBoolean() ? 1 : -1, random.nextGaussian()).normalized();
    }

    /** m v' = m g + s w x v, the spin constant; by the midpoint rule in small steps. */
    private static MeasuredRunBuilder thrown(long seed, Vec3 spin) {
        Random random = new Random(-seed);
        MeasuredRunBuilder run = MeasuredRun.named("run" + seed);
        Vec3 p = new Vec3(0, 0, 1.5);
        Vec3 v = new Vec3(15, 2 * random.nextGaussian(), 4);
        double h = SPACING / SUBSTEPS;
        for (int k = 0; k < SAMPLES; k++) {
            run.at(k * SPACING)
                    .position(
                            p.x() + NOISE * random.nextGaussian(),
                            p.y() + NOISE * random.nextGaussian(),
                            p.z() + NOISE * random.nextGaussian());
            for (int s = 0; s < SUBSTEPS; s++) {
                Vec3 middle = v.plus(acceleration(spin, v).times(h / 2));
                p = p.plus(middle.times(h));
                v = v.plus(acceleration(spin, middle).times(h));
            }
        }
        return run;
    }

    private static Vec3 acceleration(Vec3 spin, Vec3 v) {
        return spin.cross(v).times(COEFFICIENT / MASS).plus(new Vec3(0, 0, -GRAVITY));
    }

    private static KnownStart known(Vec3 spin) {
        List<Double> deviations =
                new ArrayList<>(Collections.nCopies(RigidMotion.SIZE, Double.POSITIVE_INFINITY));
        for (int i = 9; i < RigidMotion.SIZE; i++) {
            deviations.set(i, DOUBT);
        }
        return new KnownStart(
                new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, spin), deviations);
    }
}
