package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

class JudgedTest {
    /** With one cause more a fit is at least as good, if it was brought to its end. */
    @Test
    void aSetThatFitsWorseThanOneOfItsCausesWasGivenUp() throws Exception {
        Cart cart = new Cart(1, 4, 0.1);
        Cause drag = cart.cause("linear_drag");
        Cause current = cart.cause("current_constant");
        Judged one =
                Descent.of(cart.fit(Hypothesis.NONE.and(drag, new double[] {3})).whole()).steps(20);
        Hypothesis both = Hypothesis.NONE.and(drag, new double[] {1}).and(current, new double[3]);
        Judged givenUp = Judged.of(cart.fit(both).whole());

        assertThat(givenUp.isBehind(one)).isTrue();
        assertThat(Descent.of(givenUp).steps(40).isBehind(one)).isFalse();
        assertThat(one.isBehind(givenUp)).isFalse();
    }
}
