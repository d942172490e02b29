package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Guess;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.result.Identifiability;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

import java.util.Arrays;
import java.util.List;

/** A motor that fails soon after the beginning leaves nearly the trace of one that is weak. */
class TracesTest {
    private static final Cart CART = new Cart(0.8, 1e-5, 0);

    @Test
    void whatWasFoundIsComparedWhereItWasFound() throws Exception {
        Cause loss = CART.cause("thruster_loss");
        Cause gain = CART.cause("thruster_gain");
        Cause drag = CART.cause("linear_drag");
        Fit failed =
                CART.fit(new Hypothesis(List.of(loss), List.of(new double[] {0.2, 0.3}))).whole();

        Traces traces =
                new Screen(failed, List.of(gain, drag), guesses(gain, drag), failed.outcome())
                        .traces();

        assertThat(traces.alike(loss)).containsExactly(gain);
    }

    /** On a cart the numbers of a drag aside and upwards leave no trace. */
    @Test
    void whatLeavesNoTraceMakesNothingDifferent() throws Exception {
        Cause ofAxes = CART.cause("anisotropic_drag");
        Cause drag = CART.cause("quadratic_drag");
        Cause gain = CART.cause("thruster_gain");
        Fit slowed =
                CART.fit(new Hypothesis(List.of(ofAxes), List.of(new double[] {0.5, 0, 0})))
                        .whole();

        Traces traces =
                new Screen(slowed, List.of(drag, gain), guesses(drag, gain), slowed.outcome())
                        .traces();

        assertThat(traces.alike(ofAxes)).containsExactly(drag);
    }

    /** Two causes of one name: both are seen, and none is confused with itself. */
    @Test
    void causesThatShareANameAreTwo() throws Exception {
        Cause one = new Named(CART.cause("thruster_gain"), "one");
        Cause other = new Named(CART.cause("linear_drag"), "other");
        Cause third = new Named(CART.cause("thruster_gain"), "third");
        Fit fit = CART.fit(Hypothesis.NONE).whole();

        Identifiability told =
                new Screen(
                                fit,
                                List.of(one, other, third),
                                guesses(one, other, third),
                                fit.outcome())
                        .traces()
                        .identifiability(List.of());

        assertThat(told.pairs())
                .extracting(Identifiability.Confusion::first, Identifiability.Confusion::second)
                .contains(tuple("one", "third"));
        assertThat(told.smallest())
                .extracting(Identifiability.Smallest::parameter)
                .containsExactlyInAnyOrder("factor", "c", "factor");
    }

    /** Upwards nothing was measured. */
    @Test
    void aCauseIsInOneListOnly() throws Exception {
        Cause weight = CART.cause("buoyancy_weight");
        Cause gain = CART.cause("thruster_gain");
        Cause mass = CART.cause("mass_error");
        Cause faint = new Faint(gain);
        Fit fit = CART.fit(Hypothesis.NONE).whole();

        Identifiability told =
                new Screen(
                                fit,
                                List.of(weight, faint, gain, mass),
                                guesses(weight, faint, gain, mass),
                                fit.outcome())
                        .traces()
                        .identifiability(List.of());

        assertThat(told.unobservable()).containsExactly("buoyancy_weight");
        assertThat(told.unseen()).containsExactly("faint");
        assertThat(told.pairs())
                .extracting(Identifiability.Confusion::first, Identifiability.Confusion::second)
                .containsExactly(tuple("thruster_gain (motor)", "mass_error"));
    }

    /** One that does next to nothing, but that like another one. */
    private record Faint(Cause cause) implements Cause {
        private static final double SHARE = 1e-7;

        @Override
        public String id() {
            return "faint";
        }

        @Override
        public List<Parameter> parameters() {
            return cause.parameters();
        }

        @Override
        public Variant in(Variant model, double[] theta) {
            return cause.in(model, Arrays.stream(theta).map(t -> SHARE * t).toArray());
        }

        @Override
        public List<Guess> guesses(List<MeasuredRun> runs) {
            return cause.guesses(runs);
        }
    }

    /** One that has its name with others in common. */
    private record Named(Cause cause, String label) implements Cause {
        @Override
        public String id() {
            return "same";
        }

        @Override
        public List<Parameter> parameters() {
            return cause.parameters();
        }

        @Override
        public Variant in(Variant model, double[] theta) {
            return cause.in(model, theta);
        }

        @Override
        public List<Guess> guesses(List<MeasuredRun> runs) {
            return cause.guesses(runs);
        }
    }

    /** A failure shows best early in the run: that is the one that could least have been missed. */
    @Test
    void whatCouldHaveBeenMissedIsToldWhereItShowsBest() throws Exception {
        Fit sound = new Cart(1, 0, 0).fit(Hypothesis.NONE).whole();
        Cause loss = CART.cause("thruster_loss");
        List<Seed.Guesses> all = guesses(loss);
        List<Guess> guesses = all.getFirst().guesses();

        double best = smallest(sound, all);

        assertThat(guesses).hasSizeGreaterThan(2);
        assertThat(guesses.stream().mapToDouble(g -> smallest(sound, of(loss, g))))
                .allSatisfy(alone -> assertThat(alone).isGreaterThanOrEqualTo(best))
                .contains(best);
    }

    private static double smallest(Fit fit, List<Seed.Guesses> guesses) {
        List<Cause> causes = guesses.stream().map(Seed.Guesses::cause).toList();
        return new Screen(fit, causes, guesses, fit.outcome())
                .traces().identifiability(List.of()).smallest().stream()
                        .mapToDouble(Identifiability.Smallest::size)
                        .min()
                        .orElse(Double.POSITIVE_INFINITY);
    }

    private static List<Seed.Guesses> of(Cause cause, Guess guess) {
        return List.of(new Seed.Guesses(cause, List.of(guess)));
    }

    private static List<Seed.Guesses> guesses(Cause... causes) throws Exception {
        List<MeasuredRun> runs = List.of(CART.run());
        return List.of(causes).stream().map(c -> new Seed.Guesses(c, c.guesses(runs))).toList();
    }
}
