package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Descent;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.LeaveOneOut;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Objects;

/** A cart whose errors are mostly noise is foretold better by a drag that hardly shows in them. */
class ForetoldTest {
    private static final double SLIGHT = 1.3e-5;
    private static final Cart CART = new Cart(1, SLIGHT, 0);

    private static Foretold with(double drag) throws Exception {
        return Foretold.of(
                fitted(Hypothesis.NONE), fitted(drag(drag)), Noise.of(List.of(CART.run())));
    }

    private static Hypothesis drag(double c) throws Exception {
        return new Hypothesis(List.of(CART.cause("linear_drag")), List.of(new double[] {c}));
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

    /** From the starts that suit a wrong cause the model as it is would miss what it does not. */
    @Test
    void ofWhatExplainsNothingEachIsForetoldFromStartsOfItsOwn() throws Exception {
        Judged believed = fitted(Hypothesis.NONE);
        Judged wrong = fitted(drag(5));
        Noise noise = Noise.of(List.of(CART.run()));
        Gain ofOwn = ofPosition(Foretold.ofUnexplained(believed, wrong, noise));
        Gain ofWrong = ofPosition(Foretold.of(believed, wrong, noise));

        assertThat(ofOwn.before()).isLessThan(1.2 * ofOwn.noise());
        assertThat(ofOwn.after()).isGreaterThan(3 * ofOwn.noise());
        assertThat(ofWrong.before()).isGreaterThan(3 * ofOwn.noise());
    }

    private static Gain ofPosition(Foretold of) {
        return Objects.requireNonNull(of.gains().get(Channel.POSITION));
    }

    /**
     * A weak motor is foretold of each run by the others, unless one run alone was driven by it.
     */
    @Test
    void whatOneRunAloneAsksForNoneForetells() throws Exception {
        Cart weak = new Cart(0.98, 1e-5, 0);
        Cart strong = new Cart(1, 1e-5, 0);

        assertThat(isForetold(List.of(weak, weak, weak))).isTrue();
        assertThat(isForetold(List.of(strong, strong, weak))).isFalse();
    }

    private static boolean isForetold(List<Cart> carts) throws Exception {
        return isForetold(
                carts, Hypothesis.NONE.and(CART.cause("thruster_gain"), new double[] {-0.01}), 0);
    }

    /** Water that flows in one run alone is not foretold beside a drag that is there in all. */
    @Test
    void aCauseIsAskedForWhatItGainsBesideAnother() throws Exception {
        Cart still = new Cart(1, 2, 0);
        Cart afloat = new Cart(1, 2, 0.05);
        Hypothesis both =
                Hypothesis.NONE
                        .and(CART.cause("linear_drag"), new double[] {2})
                        .and(CART.cause("current_constant"), new double[] {0.02, 0, 0});

        assertThat(isForetold(List.of(still, still, afloat), both, 0)).isTrue();
        assertThat(isForetold(List.of(still, still, afloat), both, 1)).isFalse();
        assertThat(isForetold(List.of(afloat, afloat, afloat), both, 1)).isTrue();
    }

    /** Whether what one of the causes gains beside the others is. */
    private static boolean isForetold(List<Cart> carts, Hypothesis causes, int cause)
            throws Exception {
        List<MeasuredRun> runs = carts.stream().map(Cart::run).toList();
        Noise noise = Noise.of(runs);
        Course course = new Course(Progress.SILENT);
        Judged others = fitted(causes.without(cause), runs, noise);
        Judged found = fitted(causes, runs, noise);
        return Foretold.byTurns(
                        new LeaveOneOut(others, course), new LeaveOneOut(found, course), noise)
                .isMuchOf(others, found);
    }

    private static Judged fitted(Hypothesis hypothesis, List<MeasuredRun> runs, Noise noise)
            throws Exception {
        Stepping stepping = Stepping.exact(Cart.believed());
        Fit fit = Following.of(stepping, hypothesis, Misses.of(runs, noise), noise);
        return Descent.of(fit.whole()).steps(8);
    }

    @Test
    void whatChangesNothingDoesNot() throws Exception {
        assertThat(with(0).isBetter()).isFalse();
        assertThat(with(-SLIGHT).isBetter()).isFalse();
    }
}
