package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.result.Alternative;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

import java.util.List;

/** Of a cart whose motor is weak only the way is measured. */
class UnmeasuredTest {
    private static final Cart CART = new Cart(0.8, 0, 0);

    private static Alternative to(String other) throws Exception {
        List<Cause> causes = List.of(CART.cause("thruster_gain"), CART.cause(other));
        Search.Found found = CART.found(causes);
        Judged instead =
                found.judged().stream()
                        .filter(j -> j.fit().hypothesis().causes().equals(causes.subList(1, 2)))
                        .findFirst()
                        .orElseThrow();
        return Alternatives.alternative(found.best(), instead);
    }

    /** A scale that is wrong tells a way that is too short: the cart goes as fast as believed. */
    @Test
    void aScaleThatIsWrongWouldShowInTheVelocity() throws Exception {
        Alternative scale = to("sensor_scale");

        assertThat(scale.isIndistinguishable()).isTrue();
        assertThat(scale.otherSensor())
                .matches("velocity along x, by [0-9.]+ m/s \\(root mean square\\)");
    }

    /** A cart that is heavier moves the same in every respect. */
    @Test
    void aMassThatIsWrongWouldShowNowhere() throws Exception {
        Alternative mass = to("mass_error");

        assertThat(mass.isIndistinguishable()).isTrue();
        assertThat(mass.otherSensor()).isEmpty();
    }
}
