package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

import java.util.List;

/** Whether runs of carts want the same gain of their motor. */
class AgreementTest {
    private static final Cart WEAK = new Cart(0.8, 1e-5, 0);

    @Test
    void runsOfOneCartWantTheSame() throws Exception {
        assertThat(agree(WEAK.run(), WEAK.run(100))).isTrue();
    }

    @Test
    void runsOfTwoCartsDoNot() throws Exception {
        assertThat(agree(WEAK.run(), new Cart(0.79, 1e-5, 0).run())).isFalse();
    }

    /** A model without causes has no numbers to want. */
    @Test
    void nothingIsWantedOfNothing() throws Exception {
        assertThat(agree(Hypothesis.NONE, WEAK.run(), new Cart(0.6, 1e-5, 0).run())).isTrue();
    }

    private static boolean agree(MeasuredRun... runs) throws Exception {
        Hypothesis gain =
                new Hypothesis(List.of(WEAK.cause("thruster_gain")), List.of(new double[] {-0.2}));
        return agree(gain, runs);
    }

    private static boolean agree(Hypothesis hypothesis, MeasuredRun... runs) throws Exception {
        List<MeasuredRun> all = List.of(runs);
        Noise noise = Noise.of(all);
        Fit followed =
                Following.of(
                        Stepping.exact(Cart.believed()), hypothesis, Misses.of(all, noise), noise);
        Judged together = Descent.of(Refinement.approach(followed, 1)).steps(12);
        return Agreement.ofEach(together, new LeaveOneOut(together, Course.UNHEARD));
    }
}
