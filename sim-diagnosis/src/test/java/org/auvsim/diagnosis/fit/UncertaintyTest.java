package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.diagnosis.subject.FreeSphere;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;

/** How well numbers are known of a sphere of 1 kg whose way in a plane is measured. */
class UncertaintyTest {
    private static final double NOISE = 0.01;

    /** Where it is does not matter: only what would change it. */
    private static MeasuredRun run(double begin) {
        MeasuredRunBuilder run = MeasuredRun.named("still");
        for (int k = 0; k < 100; k++) {
            run.at(begin + 0.1 * k).position(NOISE * (k % 2), NOISE * (k % 2), Double.NaN);
            run.deviation(Channel.POSITION, NOISE, NOISE, NOISE);
        }
        return run.build();
    }

    private static double deviation(String quantity, BelievedModel model, String id, double... of) {
        Cause cause = cause(model, run(0), id);
        List<String> names = cause.quantities(of).stream().map(Quantity::name).toList();
        return deviations(model, id, of).get(names.indexOf(quantity));
    }

    private static Cause cause(BelievedModel model, MeasuredRun run, String id) {
        return Library.named(List.of(id), Library.of(model, List.of(run))).getFirst();
    }

    private static List<Double> deviations(BelievedModel model, String id, double... of) {
        return deviations(model, run(0), id, of);
    }

    private static List<Double> deviations(
            BelievedModel model, MeasuredRun run, String id, double... of) {
        return deviations(model, run, Quat.IDENTITY, id, of);
    }

    private static List<Double> deviations(
            BelievedModel model, MeasuredRun run, Quat orientation, String id, double... of) {
        Cause cause = cause(model, run, id);
        RigidMotion still = new RigidMotion(Vec3.ZERO, orientation, Vec3.ZERO, Vec3.ZERO);
        Fit fit =
                new Fit(
                        Stepping.exact(model),
                        List.of(new Misses(run, Noise.of(List.of(run)))),
                        new Hypothesis(List.of(cause), List.of(of)),
                        List.of(List.of(new Window(0, run.size() - 1, still))),
                        Knowledge.NONE);
        return new Uncertainty(Judged.of(fit)).deviations().getFirst();
    }

    private static BelievedModel inAPlane() throws Exception {
        return Believed.model(
                """
                <scenario><time-step delta="0.1"/>
                  <world-object name="sledge" mass="1"><box><size x="2" y="1" z="1"/></box>
                    <held z="1" turn-x="1" turn-y="1"/>
                    <damping><linear x="1" y="2" z="3"/></damping>
                  </world-object>
                </scenario>
                """,
                "sledge");
    }

    private static BelievedModel heldToX() throws Exception {
        return Believed.model(
                """
                <scenario><time-step delta="0.1"/>
                  <world-object name="sledge" mass="1"><sphere radius="0.1"/>
                    <held y="1" z="1" turn-x="1" turn-y="1" turn-z="1"/>
                    <isotropic-drag linear="1"/>
                  </world-object>
                </scenario>
                """,
                "sledge");
    }

    @Test
    void ofAForceOnlyWhatABodyFeelsIsKnown() throws Exception {
        assertThat(deviations(heldToX(), "step_force", 0.5, 0, 0, 3))
                .satisfiesExactly(
                        x -> assertThat(x).isBetween(1e-3, 10.0),
                        y -> assertThat(y).isNaN(),
                        z -> assertThat(z).isNaN(),
                        from -> assertThat(from).isBetween(1e-3, 10.0));
        assertThat(deviations(heldToX(), "current_constant", 0.5, 0, 0))
                .satisfiesExactly(
                        x -> assertThat(x).isBetween(1e-3, 10.0),
                        y -> assertThat(y).isNaN(),
                        z -> assertThat(z).isNaN());
    }

    /** What it does not feel of a force that swings changes neither its phase nor its size. */
    @Test
    void thePhaseOfAForceIsKnownByThePartThatABodyFeels() throws Exception {
        assertThat(deviations(heldToX(), "periodic_force", 0.5, 0, 0, 0.2, 0, 0, 2))
                .satisfiesExactly(
                        x -> assertThat(x).isBetween(1e-3, 10.0),
                        y -> assertThat(y).isNaN(),
                        z -> assertThat(z).isNaN(),
                        omega -> assertThat(omega).isBetween(1e-3, 10.0),
                        phase -> assertThat(phase).isBetween(1e-3, 10.0));
    }

    /** Water that rises past a sledge would move it, were it not level but for rounding. */
    @Test
    void whatLeavesNoTraceButOfRoundingMakesNothingElseUncertain() throws Exception {
        Quat level = new Quat(1, 0, 1e-12, 0);
        double[] u = {0.2, 0, 1e-8, 0.1, 0, 2e-8, 0.6};

        assertThat(deviations(inAPlane(), run(0), level, "current_oscillating", u))
                .satisfiesExactly(
                        x -> assertThat(x).isBetween(1e-3, 10.0),
                        y -> assertThat(y).isBetween(1e-3, 10.0),
                        z -> assertThat(z).isNaN(),
                        omega -> assertThat(omega).isBetween(1e-3, 10.0),
                        phase -> assertThat(phase).isBetween(1e-3, 10.0));
    }

    /** The phase is that of time 0: as unsure as the frequency times all the time since then. */
    @ParameterizedTest
    @ValueSource(doubles = {36_000, 1_718_000_000})
    void thePhaseOfALateRunIsAsUnsureAsItsFrequency(double begin) throws Exception {
        List<Double> late =
                deviations(heldToX(), run(begin), "periodic_force", 0.5, 0, 0, 0.2, 0, 0, 2);
        double ofOmega = late.get(3);

        assertThat(late.get(4)).isCloseTo(begin * ofOmega, within(0.01 * begin * ofOmega));
        assertThat(late.getFirst()).isBetween(1e-3, 10.0);
    }

    /** Waves of 0.5 N that run nearly along x, and as nearly to the other side of it. */
    @Test
    void aDirectionIsKnownAsWellOnEitherSideOfX() throws Exception {
        BelievedModel model = FreeSphere.believed(0.1);
        double left = deviation("direction", model, "wave_forcing", 0.5, 0, 1e-5, 2, 1);

        assertThat(left).isBetween(0.1, 10.0);
        assertThat(deviation("direction", model, "wave_forcing", 0.5, 0, -1e-5, 2, 1))
                .isCloseTo(left, within(0.01 * left));
    }

    /** A phase of nearly half a turn, and as nearly of minus that. */
    @Test
    void aPhaseIsKnownAsWellOnEitherSideOfHalfATurn() throws Exception {
        BelievedModel model = FreeSphere.believed(0.1);
        double before = deviation("phase", model, "wave_forcing", -0.5, 1e-9, 0.3, 2, 1);

        assertThat(before).isBetween(0.1, 10.0);
        assertThat(deviation("phase", model, "wave_forcing", -0.5, -1e-9, 0.3, 2, 1))
                .isCloseTo(before, within(0.01 * before));
    }

    /** A force that is the same everywhere is told half a turn off where it turns into a wave. */
    @Test
    void aForceThatIsTheSameEverywhereHasADirectionThatIsKnown() throws Exception {
        BelievedModel model = FreeSphere.believed(0.1);
        double left = deviation("direction", model, "wave_forcing", 0.5, 0, 0.01, 2, 0);

        assertThat(left).isBetween(0.1, 10.0);
        assertThat(deviation("direction", model, "wave_forcing", 0.5, 0, -0.01, 2, 0))
                .isCloseTo(left, within(0.1 * left));
    }
}
