package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.WindowDerivatives.Moves;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

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
            double size = distance(whole.byParameter[p], new double[whole.misses.length]);
            assertThat(error).as(names.get(p)).isLessThan(SHARE * size + SMALL);
        }
    }

    private static double distance(double[] a, double[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += (a[i] - b[i]) * (a[i] - b[i]);
        }
        return Math.sqrt(sum);
    }
}
