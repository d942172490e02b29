package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import java.util.List;

/** A cart with drag that its model lacks. */
class TournamentTest {
    private static final double DRAG = 5;
    private static final double GUESSED_GAIN = -0.3;
    private static final double GUESSED_ZONE = 0.05;

    private final Cart cart = new Cart(1, DRAG, 0);
    private Judged none;
    private Screen.Start drag;
    private Screen.Start gain;

    @BeforeEach
    void sets() throws Exception {
        none = Judged.of(cart.fit(Hypothesis.NONE).whole());
        drag = start(cart.cause("linear_drag"), 4, 2);
        gain = start(cart.cause("thruster_gain"), GUESSED_GAIN, 1);
    }

    private Screen.Start start(Cause cause, double number, double promise) throws Exception {
        Hypothesis hypothesis = new Hypothesis(List.of(cause), List.of(new double[] {number}));
        return new Screen.Start(cart.fit(hypothesis), 2, promise);
    }

    private static double number(Judged of) {
        return of.fit().hypothesis().numbers()[0];
    }

    @Test
    void whatCannotComeCloseIsGivenUp() {
        List<Judged> last = last(none, List.of(gain, drag));

        assertThat(number(of(drag, last))).isCloseTo(DRAG, within(0.01));
        assertThat(of(drag, last).isWhite()).isTrue();
        assertThat(number(of(gain, last))).isEqualTo(GUESSED_GAIN);
    }

    @Test
    void soItIsBesideWhatWasFoundBefore() {
        Judged found = of(drag, last(none, List.of(drag)));

        assertThat(number(of(gain, last(found, List.of(gain))))).isEqualTo(GUESSED_GAIN);
    }

    @Test
    void whileNothingExplainsAllOthersComeAsCloseAsTheyCan() {
        Judged alone = of(gain, last(none, List.of(gain)));

        assertThat(alone.isWhite()).isFalse();
        assertThat(number(alone)).isNotEqualTo(GUESSED_GAIN);
        assertThat(alone.cost()).isLessThan(Judged.of(gain.fit().whole()).cost());
    }

    /** Three causes nearly explain the run, two of them by nothing; the favourite does not. */
    @Test
    void whatMissesMoreThanSeveralCausesDoIsGivenUp() throws Exception {
        Hypothesis several =
                new Hypothesis(
                        List.of(
                                cart.cause("linear_drag"),
                                cart.cause("quadratic_drag"),
                                cart.cause("thruster_gain")),
                        List.of(new double[] {4.99}, new double[] {0}, new double[] {0}));
        Judged found = Judged.of(cart.fit(several).whole());
        Screen.Start other = start(cart.cause("thruster_deadzone"), GUESSED_ZONE, 0.5);

        assertThat(found.isWhite()).isFalse();
        assertThat(number(of(other, last(found, List.of(gain, other))))).isEqualTo(GUESSED_ZONE);
        assertThat(number(of(other, last(none, List.of(gain, other))))).isNotEqualTo(GUESSED_ZONE);
    }

    private static List<Judged> last(Judged otherwise, List<Screen.Start> starts) {
        MeasuredRun run = otherwise.fit().data().getFirst().run();
        return new Tournament(otherwise, Noise.of(List.of(run)), Course.UNHEARD, 0, 1).last(starts);
    }

    private static Judged of(Screen.Start start, List<Judged> all) {
        return all.stream()
                .filter(j -> j.fit().hypothesis().causes().equals(start.causes()))
                .findFirst()
                .orElseThrow();
    }
}
