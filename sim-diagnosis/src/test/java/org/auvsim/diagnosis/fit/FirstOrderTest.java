package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.Reading;
import org.auvsim.diagnosis.search.Seed;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.diagnosis.shooting.WindowDerivatives;
import org.auvsim.diagnosis.shooting.WindowDerivatives.Moves;
import org.auvsim.diagnosis.subject.MeasuredVehicle;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Derivatives to first order are those of whole simulations, cause by cause. */
class FirstOrderTest {
    private static final double SHARE = 0.015;
    private static final double SMALL = 1e-4;

    /** What begins within a leg, is near for a moment, or is a secant over a large change. */
    private static final Set<String> ABRUPT =
            Set.of("impulse", "step_force", "magnetic", "thruster_deadzone", "thruster_lag");

    private static BelievedModel model;
    private static Fit fit;

    @BeforeAll
    static void aVehicleIsMeasured() throws Exception {
        model = MeasuredVehicle.model(0.025);
        MeasuredRun run = MeasuredVehicle.run(model);
        Noise noise = Noise.of(List.of(run));
        fit =
                Following.of(
                        Stepping.exact(model),
                        Hypothesis.NONE,
                        Misses.of(List.of(run), noise),
                        noise);
    }

    @Test
    void ofEverySmoothCauseTheyAreThoseOfWholeSimulations() {
        List<MeasuredRun> runs = List.of(fit.data().getFirst().run());
        List<Seed.Guesses> guesses =
                Library.of(model, runs).stream()
                        .filter(cause -> !ABRUPT.contains(cause.id()))
                        .map(cause -> new Seed.Guesses(cause, cause.guesses(runs)))
                        .toList();
        List<Seed> seeds = Seed.of(guesses.stream().map(Seed.Guesses::cause).toList(), guesses, 0);
        List<Variant> variants = new ArrayList<>();
        List<Double> steps = new ArrayList<>();
        List<String> names = new ArrayList<>();
        for (Seed seed : seeds) {
            for (int c = 0; c < seed.columns().length; c++) {
                variants.add(seed.moved(model.variant(), c));
                steps.add(seed.guess().steps().get(c));
                names.add(seed.cause().name() + " " + seed.guess());
            }
        }
        Moves moves = new Moves(variants, steps);
        List<WindowDerivatives> windows = FirstOrder.derivatives(fit, moves).getFirst();
        Window only = windows.getFirst().window;
        WindowDerivatives whole = fit.shooting(fit.data().getFirst()).derivatives(only, 8, moves);

        assertThat(windows).hasSize(1);
        assertThat(variants).hasSizeGreaterThan(500);
        for (int p = 0; p < variants.size(); p++) {
            double error = distance(windows.getFirst().byParameter[p], whole.byParameter[p]);
            double size = size(whole.byParameter[p]);
            assertThat(error).as(names.get(p)).isLessThan(SHARE * size + SMALL);
        }
    }

    /** A fix in every tenth row weighs as much as it says, in screening as in a fit. */
    @Test
    void numbersInSomeRowsOnlyLoseNothingWhereRowsAreTakenTogether() {
        MeasuredRun run = fit.data().getFirst().run();
        Set<Reading> between =
                IntStream.range(0, run.size())
                        .filter(k -> k % 10 != 5)
                        .boxed()
                        .flatMap(
                                k ->
                                        IntStream.range(0, 3)
                                                .mapToObj(i -> new Reading(Channel.POSITION, k, i)))
                        .collect(Collectors.toSet());
        List<MeasuredRun> sparse = List.of(run.without(between));
        Noise noise = Noise.of(sparse);
        List<Misses> data = Misses.of(sparse, noise);
        Fit ofSparse =
                new Fit(fit.stepping(), data, fit.hypothesis(), fit.windows(), Knowledge.NONE);
        Variant drifting = model.variant().sensed(s -> s.drifting(new Vec3(1e-3, 0, 0)));
        Variant heavier = model.variant().with(body -> body.mass(12.01));
        Moves moves = new Moves(List.of(drifting, heavier), List.of(1e-3, 0.01));

        WindowDerivatives together = FirstOrder.derivatives(ofSparse, moves).getFirst().getFirst();
        WindowDerivatives single =
                ofSparse.shooting(data.getFirst()).derivatives(together.window, 1, moves);

        assertThat(together.misses.length).isLessThan(single.misses.length / 4);
        for (int p = 0; p < moves.size(); p++) {
            double size = size(single.byParameter[p]);
            assertThat(size(together.byParameter[p])).isCloseTo(size, within(0.05 * size));
        }
    }

    private static double size(double[] column) {
        return distance(column, new double[column.length]);
    }

    private static double distance(double[] a, double[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += (a[i] - b[i]) * (a[i] - b[i]);
        }
        return Math.sqrt(sum);
    }
}
