package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.List;
import java.util.Random;

/** Windows of a cart that slows down by a drag, of which only the velocity is measured. */
class FollowingTest {
    private static final double NOISE = 0.002;
    private static final double SPACING = 0.05;
    private static final int SAMPLES = 400;

    /** A model without the drag follows for a while only; that with it all the way. */
    @ParameterizedTest
    @CsvSource({"0.0, 8, 32", "3.0, 1, 1"})
    void theyAreAsLongAsTheModelFollowsTheVelocity(double drag, int least, int most)
            throws Exception {
        MeasuredRun run = slowing();
        Noise noise = Noise.of(List.of(run));
        BelievedModel model = Cart.believed();
        Hypothesis hypothesis =
                new Hypothesis(
                        List.of(new Cart(1, 0, 0).cause("linear_drag")),
                        List.of(new double[] {drag}));

        Fit fit =
                Following.of(
                        Stepping.exact(model), hypothesis, Misses.of(List.of(run), noise), noise);

        List<Window> windows = fit.windows().getFirst();
        assertThat(windows).hasSizeBetween(least, most);
        assertThat(windows)
                .allSatisfy(
                        window ->
                                assertThat(window.start().velocity().x())
                                        .isBetween(
                                                run.value(Channel.VELOCITY, window.to(), 0) - 0.1,
                                                run.value(Channel.VELOCITY, window.from(), 0)
                                                        + 0.1));
    }

    /** A window that has one fix begins as fast as the noise has it, and tells nothing. */
    @Test
    void eachHasSomeFixesOfThePlace() throws Exception {
        Random random = new Random(9);
        MeasuredRunBuilder builder = MeasuredRun.named("fixes").commands(List.of("motor"));
        for (int k = 0; k < SAMPLES; k++) {
            double x = 2 / 0.3 * (1 - Math.exp(-0.3 * k * SPACING));
            boolean isFix = k % 10 == 0;
            builder.at(k * SPACING).command(0, 0);
            builder.position(isFix ? x + NOISE * random.nextGaussian() : Double.NaN, 0, 0);
        }
        MeasuredRun run = builder.build();
        Noise noise = Noise.of(List.of(run));

        Fit fit =
                Following.of(
                        Stepping.exact(Cart.believed()),
                        Hypothesis.NONE,
                        Misses.of(List.of(run), noise),
                        noise);

        assertThat(fit.windows().getFirst())
                .hasSizeBetween(2, SAMPLES / 10 / 8)
                .allSatisfy(window -> assertThat(window.length()).isGreaterThan(80));
    }

    /** From 2 m/s, by 3 N s/m of 10 kg. */
    private static MeasuredRun slowing() {
        Random random = new Random(8);
        MeasuredRunBuilder run = MeasuredRun.named("slowing").commands(List.of("motor"));
        for (int k = 0; k < SAMPLES; k++) {
            double v = 2 * Math.exp(-0.3 * k * SPACING);
            run.at(k * SPACING)
                    .measured(
                            Channel.VELOCITY,
                            v + NOISE * random.nextGaussian(),
                            Double.NaN,
                            Double.NaN)
                    .command(0, 0);
        }
        return run.build();
    }
}
