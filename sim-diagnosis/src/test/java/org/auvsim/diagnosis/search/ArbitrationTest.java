package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Descent;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/** Models of a cart that has drag, each run left out in turn. */
class ArbitrationTest {
    private static final int STEPS = 8;
    private static final Cart CART = new Cart(1, 4, 0);

    private final MeasuredRun whole = CART.run();
    private final List<MeasuredRun> parts =
            List.of(
                    whole.part("first", 0, 132),
                    whole.part("second", 133, 265),
                    whole.part("third", 266, 399));

    private final Judged drag = fitted("linear_drag");
    private final Judged gain = fitted("thruster_gain");
    private final Judged both = fitted("linear_drag", "thruster_gain");

    ArbitrationTest() throws Exception {}

    @Test
    void whatPredictsRunsThatItDidNotSeeIsBelieved() {
        assertThat(decided(gain, drag)).isEqualTo(drag);
        assertThat(decided(drag, gain)).isEqualTo(drag);
    }

    /**
     * A motor of which nothing is wrong, beside the drag, moves the cart as the drag alone does.
     */
    @Test
    void whatNoRunTellsApartStaysAsItWasFound() {
        assertThat(decided(drag, both)).isEqualTo(drag);
        assertThat(decided(both, drag)).isEqualTo(both);
    }

    @Test
    void aLargerModelGainsNoMoreOfLeftOutRunsThanOfThoseThatItSaw() {
        double seen = gain.outcome().deviance() - both.outcome().deviance();

        assertThat(seen).isPositive();
        assertThat(Arbitration.mostGain(gain, both)).isEqualTo(seen);
        assertThat(Arbitration.mostGain(both, gain)).isInfinite();
        assertThat(Arbitration.mostGain(gain, drag)).isInfinite();
    }

    @Test
    void whoIsToldToStopKeepsWhatWasFound() {
        Course stopped = new Course((stage, share) -> false);
        stopped.at("deciding", 0.9);

        assertThat(Arbitration.decided(gain, List.of(drag), stopped)).isEqualTo(gain);
    }

    private static Judged decided(Judged best, Judged other) {
        return Arbitration.decided(best, List.of(other), new Course(Progress.SILENT));
    }

    private Judged fitted(String... ids) throws Exception {
        List<Cause> causes = new ArrayList<>();
        List<double[]> numbers = new ArrayList<>();
        for (String id : ids) {
            causes.add(CART.cause(id));
            numbers.add(new double[1]);
        }
        Noise noise = Noise.of(parts);
        Fit fit =
                Following.of(
                        Stepping.longer(Cart.believed()).getFirst(),
                        new Hypothesis(causes, numbers),
                        Misses.of(parts, noise),
                        noise);
        return Descent.of(fit.whole()).steps(STEPS);
    }
}
