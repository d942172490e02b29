package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.shooting.WindowDerivatives;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TangentsTest {
    private static final Cart CART = new Cart(1, 4, 0);

    /** What drag does is linear as long as it is nearly the same. */
    @ParameterizedTest(name = "from 4 to {0} N s/m")
    @CsvSource({"4, true", "4.01, true", "4.2, true", "30, false"})
    void theyAreTakenAnewWhereTheyForetoldSomethingElse(double drag, boolean isKept)
            throws Exception {
        Fit fit = fit(4);
        Tangents tangents = Tangents.of(Simulated.of(fit));
        Simulated elsewhere = Simulated.of(fit.with(fit(drag).hypothesis(), fit.windows()));

        Tangents there = tangents.at(elsewhere);

        WindowDerivatives before = tangents.derivatives().getFirst().getFirst();
        WindowDerivatives after = there.derivatives().getFirst().getFirst();
        assertThat(after.misses).isEqualTo(exact(elsewhere).misses);
        assertThat(there.off() > 0).isEqualTo(isKept && drag != 4);
        assertThat(after.byParameter[0])
                .isEqualTo((isKept ? before : exact(elsewhere)).byParameter[0]);
    }

    private static Fit fit(double drag) throws Exception {
        Cause cause = CART.cause("linear_drag");
        return CART.fit(Hypothesis.NONE.and(cause, new double[] {drag})).whole();
    }

    private static WindowDerivatives exact(Simulated fit) {
        return Tangents.of(fit).derivatives().getFirst().getFirst();
    }
}
