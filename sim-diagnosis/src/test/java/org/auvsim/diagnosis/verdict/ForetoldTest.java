package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.fit.Descent;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

import java.util.List;

/** A cart whose errors are mostly noise is foretold better by a drag that hardly shows in them. */
class ForetoldTest {
    private static final double SLIGHT = 1.3e-5;
    private static final Cart CART = new Cart(1, SLIGHT, 0);

    private static Foretold with(double drag) throws Exception {
        Hypothesis found =
                new Hypothesis(List.of(CART.cause("linear_drag")), List.of(new double[] {drag}));
        return Foretold.of(fitted(Hypothesis.NONE), fitted(found), Noise.of(List.of(CART.run())));
    }

    /** From a start of its own. */
    private static Judged fitted(Hypothesis hypothesis) throws Exception {
        return Descent.of(Judged.of(CART.fit(hypothesis.settled()).whole())).steps(8);
    }

    @Test
    void whatIsThereForetellsBetterThanChance() throws Exception {
        Foretold foretold = with(SLIGHT);

        assertThat(foretold.isBetter()).isTrue();
        assertThat(foretold.gains().get(Channel.POSITION))
                .satisfies(gain -> assertThat(gain.after()).isLessThan(gain.before()))
                .satisfies(gain -> assertThat(gain.after()).isGreaterThan(0.95 * gain.before()));
    }

    @Test
    void whatChangesNothingDoesNot() throws Exception {
        assertThat(with(0).isBetter()).isFalse();
        assertThat(with(-SLIGHT).isBetter()).isFalse();
    }
}
