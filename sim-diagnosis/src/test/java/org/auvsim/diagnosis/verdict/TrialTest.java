package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.fit.Agreement;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Knowledge;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

import java.util.List;

/** A motor of 0.8 of its thrust on a held-out run, of which the runs of the fit said so or so. */
class TrialTest {
    private static final Cart CART = new Cart(0.8, 1e-5, 0);

    @Test
    void aPredictionThatIsNearlyRightMayBeMovedAndHolds() throws Exception {
        assertThat(passes(-0.25)).isTrue();
    }

    /**
     * By 0.8 too little is worse than by 0.2 too much, though it could be moved to what is right.
     */
    @Test
    void onePoorerThanNoneDoesNotHoldThoughItCouldBeMoved() throws Exception {
        assertThat(passes(-0.9)).isFalse();
    }

    /** It can be moved to what is right, but the fit has said that it is not there. */
    @Test
    void aPredictionThatWasSureOfSomethingElseDoesNotAgree() throws Exception {
        assertThat(agrees(0.005)).isFalse();
        assertThat(agrees(1)).isTrue();
    }

    private static boolean agrees(double deviation) throws Exception {
        Hypothesis said = said(-0.25);
        Knowledge known = Knowledge.of(said.numbers(), 0, deviation);
        return Agreement.of(Trial.adjusted(fitted(said), trial().prediction(said), known));
    }

    /** Whether a gain that is off by so much holds; the fit leaves it open. */
    private static boolean passes(double gain) throws Exception {
        Hypothesis said = said(gain);
        Trial trial = trial();
        Judged predicted = trial.prediction(said);
        Knowledge known = Knowledge.of(said.numbers(), 0, 1);
        return Trial.passes(
                fitted(said),
                trial.prediction(Hypothesis.NONE),
                predicted,
                Trial.adjusted(fitted(said), predicted, known));
    }

    private static Hypothesis said(double gain) throws Exception {
        return new Hypothesis(List.of(CART.cause("thruster_gain")), List.of(new double[] {gain}));
    }

    private static Trial trial() throws Exception {
        List<MeasuredRun> runs = List.of(CART.run());
        return new Trial(Stepping.exact(Cart.believed()), runs, Noise.of(runs));
    }

    private static Judged fitted(Hypothesis said) throws Exception {
        Noise noise = Noise.of(List.of(CART.run()));
        List<Misses> data = Misses.of(List.of(CART.run()), noise);
        Stepping stepping = Stepping.exact(Cart.believed());
        return Judged.of(Following.of(stepping, said, data, noise).whole());
    }
}
