package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.ForceResidual;
import org.auvsim.diagnosis.run.KnownDifferences;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.Random;
import java.util.function.ToDoubleFunction;

/** A cart with a drag that the model does not have. */
class MissingForceTest {
    private static final double DRAG = 8;
    private static final Cart CART = new Cart(1, DRAG, 0);

    /** Windows that follow by a wrong model begin too fast or too slow for the right one. */
    @Test
    void theRightModelLacksNone() throws Exception {
        Hypothesis drag =
                new Hypothesis(List.of(CART.cause("linear_drag")), List.of(new double[] {DRAG}));
        Stepping stepping = Stepping.exact(Cart.believed());
        List<MeasuredRun> runs = List.of(CART.run());
        Noise noise = Noise.of(runs);
        Variant right = drag.in(stepping.variant());

        List<ForceResidual> forces =
                MissingForce.along(
                        stepping, right, Misses.of(runs, noise).getFirst(), noise, Course.UNHEARD);

        assertThat(forces).hasSizeGreaterThan(10);
        assertThat(mean(forces, f -> f.before().norm())).isGreaterThan(2);
        assertThat(mean(forces, f -> f.after().norm())).isLessThan(0.3);
    }

    /** A force of 3 N moves a ball of 10 kg, its ballast, and the 20 kg of water around it. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 10})
    void whatIsCarriedHasToBeMovedToo(double ballast) throws Exception {
        BelievedModel model =
                new BelievedModel(
                        ScenarioLoader.load(MissingForceTest.class.getClassLoader())
                                .parse(
                                        """
                                        <scenario><time-step delta="0.05"/>
                                          <world-object name="ball" mass="10"><sphere radius="0.2"/>
                                            <added-mass><linear x="20" y="20" z="20"/></added-mass>
                                          </world-object></scenario>
                                        """
                                                .getBytes(UTF_8)),
                        "ball");
        Random random = new Random(1);
        MeasuredRunBuilder run =
                MeasuredRun.named("run")
                        .differences(new KnownDifferences(ballast, List.of(), List.of()));
        for (int k = 0; k < 400; k++) {
            double t = 0.05 * k;
            double x = 3.0 / (30 + ballast) * t * t / 2 + 0.002 * random.nextGaussian();
            run.at(t).position(x, 0.002 * random.nextGaussian(), 0.002 * random.nextGaussian());
        }
        List<MeasuredRun> runs = List.of(run.build());
        Noise noise = Noise.of(runs);
        Stepping stepping = Stepping.exact(model);

        List<ForceResidual> forces =
                MissingForce.along(
                        stepping,
                        stepping.variant(),
                        Misses.of(runs, noise).getFirst(),
                        noise,
                        Course.UNHEARD);

        assertThat(mean(forces, f -> f.before().x())).isCloseTo(3, within(0.1));
        assertThat(mean(forces, f -> f.before().y())).isCloseTo(0, within(0.1));
    }

    private static double mean(List<ForceResidual> forces, ToDoubleFunction<ForceResidual> of) {
        return forces.stream().mapToDouble(of).average().orElseThrow();
    }
}
