package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.result.ForceResidual;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Test;

import java.util.List;
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
                MissingForce.along(stepping, right, Misses.of(runs, noise).getFirst(), noise);

        assertThat(forces).hasSizeGreaterThan(10);
        assertThat(mean(forces, f -> f.before().norm())).isGreaterThan(2);
        assertThat(mean(forces, f -> f.after().norm())).isLessThan(0.3);
    }

    private static double mean(List<ForceResidual> forces, ToDoubleFunction<ForceResidual> of) {
        return forces.stream().mapToDouble(of).average().orElseThrow();
    }
}
