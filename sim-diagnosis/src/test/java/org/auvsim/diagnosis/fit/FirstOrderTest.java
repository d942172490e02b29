package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;

import static java.nio.charset.StandardCharsets.UTF_8;

import org.auvsim.auvsml.document.ScenarioLoader;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.WindowDerivatives.Moves;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;

/** Derivatives to first order are those of whole simulations, cause by cause. */
class FirstOrderTest {
    private static final int SAMPLES = 161;
    private static final double SPACING = 0.05;
    private static final double NOISE = 0.01;
    private static final double SHARE = 0.03;
    private static final double SMALL = 1e-4;

    /** What begins within a leg, is near for a moment, or is a secant over a large change. */
    private static final Set<String> ABRUPT =
            Set.of("impulse", "step_force", "magnetic", "thruster_deadzone", "thruster_lag");

    private static BelievedModel model;
    private static Fit fit;

    @BeforeAll
    static void aVehicleIsMeasured() throws Exception {
        model =
                new BelievedModel(
                        ScenarioLoader.load(FirstOrderTest.class.getClassLoader())
                                .parse(
                                        """
                                        <scenario><time-step delta="0.025"/>
                                          <world-object name="vehicle" mass="12">
                                            <box><size x="0.8" y="0.4" z="0.3"/></box>
                                            <inertia xx="0.5" yy="0.9" zz="1.1"/>
                                            <added-mass><linear x="4" y="6" z="8"/></added-mass>
                                            <damping><linear x="3" y="5" z="6"/>
                                              <quadratic x="4" y="9" z="9"/>
                                              <angular-linear x="0.5" y="0.6" z="0.7"/></damping>
                                            <propulsor name="port" maximum-thrust="20">
                                              <position x="-0.4" y="0.15" z="0"/>
                                            </propulsor>
                                            <propulsor name="starboard" maximum-thrust="20">
                                              <position x="-0.4" y="-0.15" z="0"/>
                                            </propulsor>
                                          </world-object>
                                        </scenario>
                                        """
                                                .getBytes(UTF_8)),
                        "vehicle");
        MeasuredRun run = run();
        Noise noise = Noise.of(List.of(run));
        fit =
                Following.of(
                        Stepping.exact(model),
                        Hypothesis.NONE,
                        Misses.of(List.of(run), noise),
                        noise);
    }

    /** The model's own motion under commands that change, with noise. */
    private static MeasuredRun run() {
        Random random = new Random(5);
        MeasuredRun commands = measured(random, new RigidMotion[0]);
        RigidMotion start =
                new RigidMotion(
                        new Vec3(0.4, -0.3, 0.2),
                        new Quat(0.96, 0.1, -0.15, 0.2).normalized(),
                        new Vec3(0.5, -0.2, 0.1),
                        new Vec3(0.1, -0.2, 0.2));
        RigidMotion[] motion =
                Ensemble.simulate(
                        model,
                        commands,
                        0,
                        SAMPLES - 1,
                        List.of(new Ensemble.Entrant(model.variant(), start)))[0];
        return measured(random, motion);
    }

    private static MeasuredRun measured(Random random, RigidMotion[] motion) {
        MeasuredRunBuilder run = MeasuredRun.named("run").commands(List.of("port", "starboard"));
        for (int k = 0; k < SAMPLES; k++) {
            boolean isOutward = k / 40 % 2 == 0;
            run.at(k * SPACING).command(0, 0.6).command(1, isOutward ? 0.3 : 0.8);
            if (motion.length > 0) {
                Vec3 p = motion[k].position();
                run.position(p.x() + noise(random), p.y() + noise(random), p.z() + noise(random))
                        .orientation(motion[k].orientation());
            }
        }
        return run.build();
    }

    private static double noise(Random random) {
        return NOISE * random.nextGaussian();
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
