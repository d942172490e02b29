package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Descent;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.subject.Believed;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/** A sphere that a drag slows down, as its model has it, or in a current. */
class UndoingTest {
    private static final double DRAG = 4;
    private static final double MASS = 10;
    private static final double SPACING = 0.1;
    private static final int SAMPLES = 200;
    private static final double NOISE = 0.005;

    @Test
    void aCurrentAndADriftThatCancelUndoEachOther() throws Exception {
        assertThat(undoEachOther(0, -0.1, 0.1)).isTrue();
    }

    /** Where one of them hardly does anything, the other is not undone. */
    @Test
    void whatDoesLittleUndoesNothing() throws Exception {
        assertThat(undoEachOther(0, 1e-5, -1e-5)).isFalse();
    }

    /** What a run needs is no whim, though another cause takes a part of it away. */
    @Test
    void whatARunNeedsIsNotUndone() throws Exception {
        assertThat(undoEachOther(0.2, 0.3, -0.1)).isFalse();
    }

    /** A current and a drift of measured positions (m/s, along x) in water that moves so. */
    private static boolean undoEachOther(double water, double current, double drift)
            throws Exception {
        BelievedModel model =
                Believed.model(
                        """
                        <scenario><time-step delta="0.05"/>
                          <world-object name="sphere" mass="10"><sphere radius="0.2"/>
                            <isotropic-drag linear="4" quadratic="0" angular="0"/></world-object>
                        </scenario>
                        """,
                        "sphere");
        List<MeasuredRun> runs = List.of(run(water));
        Noise noise = Noise.of(runs);
        Fit following =
                Following.of(Stepping.exact(model), Hypothesis.NONE, Misses.of(runs, noise), noise);
        Hypothesis both =
                Hypothesis.NONE
                        .and(cause("current_constant", model, runs), new double[] {current, 0, 0})
                        .and(cause("position_drift", model, runs), new double[] {drift, 0, 0});
        return Undoing.isIn(Descent.of(following.whole()).steps(12), both);
    }

    private static Cause cause(String id, BelievedModel model, List<MeasuredRun> runs) {
        return Library.of(model, runs).stream()
                .filter(cause -> cause.id().equals(id))
                .findFirst()
                .orElseThrow();
    }

    /** From 1 m/s its speed approaches that of the water exponentially. */
    private static MeasuredRun run(double water) {
        Random random = new Random(5);
        MeasuredRunBuilder run = MeasuredRun.named("run");
        double rate = DRAG / MASS;
        for (int k = 0; k < SAMPLES; k++) {
            double t = k * SPACING;
            double x = water * t + (1 - water) / rate * -Math.expm1(-rate * t);
            run.at(t)
                    .position(
                            x + NOISE * random.nextGaussian(),
                            NOISE * random.nextGaussian(),
                            NOISE * random.nextGaussian());
        }
        return run.build();
    }
}
