package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.diagnosis.shooting.WindowDerivatives;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.diagnosis.subject.Cart;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntFunction;

class TangentsTest {
    private static final Cart CART = new Cart(1, 4, 0);

    /** Of positions and orientations. */
    private static final int MISSES = 6 * 101;

    /** What drag does is linear as long as it is nearly the same. */
    @ParameterizedTest(name = "from 4 to {0} N s/m")
    @CsvSource({"4, true", "4.01, true", "4.2, true", "30, false"})
    void theyAreTakenAnewWhereTheyForetoldSomethingElse(double drag, boolean isKept)
            throws Exception {
        Fit fit = fit(4);
        Tangents tangents = Tangents.of(Simulated.of(fit));
        Simulated elsewhere = Simulated.of(fit.with(fit(drag).hypothesis(), fit.windows()));

        Tangents there = tangents.at(elsewhere);

        WindowDerivatives before = tangents.derivatives().getFirst().getFirst();
        WindowDerivatives after = there.derivatives().getFirst().getFirst();
        assertThat(after.misses).isEqualTo(exact(elsewhere).misses);
        assertThat(there.off() > 0).isEqualTo(isKept && drag != 4);
        assertThat(after.byParameter[0])
                .isEqualTo((isKept ? before : exact(elsewhere)).byParameter[0]);
    }

    /**
     * Of a sphere that slows down in water, masses that it carries along its axes turn it if they
     * differ, which shows a thousand times more than what they do together.
     */
    @Test
    void whatParametersDoTogetherIsRightThoughTheyNearlyUndoEachOther() throws Exception {
        double[] carried = {0.010, 0.022, 0.004};
        Fit fit = slowing(carried);
        double[] exact = new double[MISSES];
        double[] more = misses(slowing(shifted(carried, 1e-5)), fit);
        double[] less = misses(slowing(shifted(carried, -1e-5)), fit);
        Arrays.setAll(exact, k -> (more[k] - less[k]) / 2e-5);

        assertThat(off(Tangents.close(Simulated.of(fit)), exact)).isLessThan(0.01);
        assertThat(off(Tangents.of(Simulated.of(fit)), exact)).isGreaterThan(0.2);
    }

    private static double[] shifted(double[] carried, double by) {
        return Arrays.stream(carried).map(mass -> mass + by).toArray();
    }

    /** By which share the sum of all columns is off. */
    private static double off(Tangents tangents, double[] exact) {
        double[][] columns = tangents.derivatives().getFirst().getFirst().byParameter;
        double wrong = 0;
        double size = 0;
        for (int k = 0; k < exact.length; k++) {
            double together = columns[0][k] + columns[1][k] + columns[2][k];
            wrong += (together - exact[k]) * (together - exact[k]);
            size += exact[k] * exact[k];
        }
        return Math.sqrt(wrong / size);
    }

    /** What the motion of one misses of the run of another. */
    private static double[] misses(Fit of, Fit run) {
        Fit there = run.with(of.hypothesis(), run.windows());
        return there.outcome().misses().getFirst();
    }

    /** A fit to a run that is just as it has it. */
    private static Fit slowing(double[] carried) throws Exception {
        BelievedModel model =
                Believed.model(
                        """
                        <scenario><time-step delta="0.05"/>
                          <world-object name="sphere" mass="1"><sphere radius="0.1"/>
                            <added-mass><linear x="0.5" y="0.5" z="0.5"/></added-mass>
                            <isotropic-drag linear="0.2"/>
                            <velocity x="1" y="0.7" z="0.3"/>
                          </world-object></scenario>
                        """,
                        "sphere");
        MeasuredRun still = run(_ -> model.start());
        RigidMotion[] motion = fit(model, still, carried).motions().getFirst();
        return fit(model, run(k -> motion[k]), carried);
    }

    private static Fit fit(BelievedModel model, MeasuredRun run, double[] carried)
            throws Exception {
        Cause cause =
                Library.named(List.of("added_mass"), Library.of(model, List.of(run))).getFirst();
        return new Fit(
                Stepping.exact(model),
                Misses.of(List.of(run), Noise.of(List.of(run))),
                Hypothesis.NONE.and(cause, carried),
                List.of(List.of(new Window(0, run.size() - 1, model.start()))),
                Knowledge.NONE);
    }

    private static MeasuredRun run(IntFunction<RigidMotion> motion) {
        MeasuredRunBuilder run = MeasuredRun.named("slowing");
        for (int k = 0; k < MISSES / 6; k++) {
            Vec3 p = motion.apply(k).position();
            run.at(0.1 * k)
                    .position(p.x(), p.y(), p.z())
                    .orientation(motion.apply(k).orientation())
                    .deviation(Channel.POSITION, 0.01, 0.01, 0.01)
                    .deviation(Channel.ORIENTATION, 0.01, 0.01, 0.01);
        }
        return run.build();
    }

    private static Fit fit(double drag) throws Exception {
        Cause cause = CART.cause("linear_drag");
        return CART.fit(Hypothesis.NONE.and(cause, new double[] {drag})).whole();
    }

    private static WindowDerivatives exact(Simulated fit) {
        return Tangents.of(fit).derivatives().getFirst().getFirst();
    }
}
