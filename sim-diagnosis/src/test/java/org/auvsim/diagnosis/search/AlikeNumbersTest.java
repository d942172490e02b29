package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Guess;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.result.Identifiability.Confusion;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** Of causes with several numbers the two are named that leave nearly the same trace. */
class AlikeNumbersTest {
    private static final Cart CART = new Cart(1, 1e-5, 0);

    /** In either order: which number it is does not depend on where it stands. */
    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void theyAreNamed(boolean isReversed) throws Exception {
        Cause gain = CART.cause("thruster_gain");
        Cause linear = CART.cause("linear_drag");
        Cause quadratic = CART.cause("quadratic_drag");
        List<Cause> parts = List.of(linear, gain);
        Cause several = new Several(isReversed ? parts.reversed() : parts);
        Fit fit = CART.fit(Hypothesis.NONE).whole();

        List<Confusion> pairs =
                new Screen(
                                fit,
                                List.of(gain, several, quadratic),
                                guesses(gain, several, quadratic),
                                fit.outcome())
                        .traces()
                        .identifiability(List.of())
                        .pairs();

        assertThat(pairs)
                .extracting(
                        Confusion::first,
                        Confusion::firstNumber,
                        Confusion::second,
                        Confusion::secondNumber)
                .containsExactly(
                        tuple("thruster_gain (motor)", "factor", "several", "thruster_gain.factor"),
                        tuple("several", "linear_drag.c", "quadratic_drag", "k"));
    }

    private static List<Seed.Guesses> guesses(Cause... causes) throws Exception {
        List<MeasuredRun> runs = List.of(CART.run());
        return List.of(causes).stream().map(c -> new Seed.Guesses(c, c.guesses(runs))).toList();
    }

    /** Causes of one number each as one. */
    private record Several(List<Cause> parts) implements Cause {
        @Override
        public String id() {
            return "several";
        }

        @Override
        public List<Parameter> parameters() {
            return parts.stream().map(Several::named).toList();
        }

        private static Parameter named(Cause part) {
            Parameter of = part.parameters().getFirst();
            return new Parameter(
                    part.id() + "." + of.name(), of.unit(), of.scale(), of.lowest(), of.highest());
        }

        @Override
        public Variant in(Variant model, double[] theta) {
            Variant with = model;
            for (int i = 0; i < theta.length; i++) {
                with = parts.get(i).in(with, new double[] {theta[i]});
            }
            return with;
        }

        @Override
        public List<Guess> guesses(List<MeasuredRun> runs) {
            List<Double> theta = new ArrayList<>();
            List<Double> steps = new ArrayList<>();
            for (Cause part : parts) {
                Guess guess = part.guesses(runs).getFirst();
                theta.add(guess.theta().getFirst());
                steps.add(guess.steps().getFirst());
            }
            return List.of(
                    new Guess(theta, IntStream.range(0, theta.size()).boxed().toList(), steps));
        }
    }
}
