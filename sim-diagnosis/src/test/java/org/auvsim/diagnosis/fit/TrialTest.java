package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Test;

import java.util.List;

/** A motor of 0.8 of its thrust on a held-out run, of which the runs of the fit said so or so. */
class TrialTest {
    private static final Cart CART = new Cart(0.8, 1e-5, 0);

    @Test
    void aPredictionThatIsNearlyRightMayBeMovedAndHolds() throws Exception {
        assertThat(passes(-0.25, 1)).isTrue();
    }

    /**
     * By 0.8 too little is worse than by 0.2 too much, though it could be moved to what is right.
     */
    @Test
    void onePoorerThanNoneDoesNotHoldThoughItCouldBeMoved() throws Exception {
        assertThat(passes(-0.9, 1)).isFalse();
    }

    /** It could be moved to what is right, too, but the fit has said that it is not there. */
    @Test
    void aPredictionThatWasSureOfSomethingElseDoesNotHold() throws Exception {
        assertThat(passes(-0.25, 0.005)).isFalse();
    }

    /** Whether a gain that is off by so much holds, of which the fit was that uncertain. */
    private static boolean passes(double gain, double deviation) throws Exception {
        Hypothesis said =
                new Hypothesis(List.of(CART.cause("thruster_gain")), List.of(new double[] {gain}));
        Stepping stepping = Stepping.exact(Cart.believed());
        List<MeasuredRun> runs = List.of(CART.run());
        Noise noise = Noise.of(runs);
        Trial trial = new Trial(stepping, runs, noise);
        Fit fit = Following.of(stepping, said, Misses.of(runs, noise), noise);
        return trial.passes(
                Judged.of(fit.whole()),
                trial.prediction(Hypothesis.NONE),
                trial.prediction(said),
                Knowledge.of(said.numbers(), 0, deviation));
    }
}
