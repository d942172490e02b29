package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.KnownStart;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.subject.FreeSphere;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.DoubleStream;

/**
 * A sphere coasts to a stop: how well its drag is known follows from the solution in closed form.
 */
class ProfileTest {
    private static final int SAMPLES = 21;
    private static final double SPACING = 0.1;
    private static final double SPEED = 2;
    private static final double DRAG = 1.5;

    @ParameterizedTest(name = "noise {0} m, seed {1}")
    @CsvSource({"0.001, 1", "0.3, 2", "0.8, 3", "0.8, 5", "0.8, 6"})
    void standardDeviationsAreStretchedAsTheLikelihoodIs(double noise, long seed) throws Exception {
        double[] measured = measured(noise, new Random(seed));
        Judged fitted = fitted(measured, noise);
        double drag = fitted.fit().hypothesis().numbers()[0];
        double deviation = 1 / Math.sqrt(information(drag, noise));

        double[] stretches =
                new Profile(
                                fitted,
                                Tangents.of(Simulated.of(fitted.fit())),
                                new Array2DRowRealMatrix(new double[][] {{deviation * deviation}}),
                                1)
                        .stretches();

        double expected =
                DoubleStream.of(drag - 2 * deviation, drag + 2 * deviation)
                        .filter(there -> there >= 0) // drag that drives is out of bounds
                        .map(there -> cost(measured, there, noise) - cost(measured, drag, noise))
                        .map(worse -> 2 / Math.sqrt(worse))
                        .average()
                        .orElseThrow();
        assertThat(stretches).hasSize(1);
        assertThat(stretches[0]).isCloseTo(expected, within(0.005));
        if (noise < 0.01) {
            assertThat(stretches[0]).isCloseTo(1, within(0.005));
        }
    }

    private static Judged fitted(double[] measured, double noise) throws Exception {
        BelievedModel model = FreeSphere.believed(0.02);
        MeasuredRun run = run(measured, noise);
        Cause drag =
                Library.of(model, List.of(run)).stream()
                        .filter(cause -> cause.id().equals("linear_drag"))
                        .findFirst()
                        .orElseThrow();
        Noise ofRun = Noise.of(List.of(run));
        Hypothesis hypothesis = new Hypothesis(List.of(drag), List.of(new double[] {DRAG}));
        Fit fit =
                Following.of(
                        Stepping.exact(model), hypothesis, Misses.of(List.of(run), ofRun), ofRun);
        return Descent.of(Refinement.approach(fit, 1)).steps(20);
    }

    private static MeasuredRun run(double[] measured, double noise) {
        RigidMotion start =
                new RigidMotion(Vec3.ZERO, Quat.IDENTITY, new Vec3(SPEED, 0, 0), Vec3.ZERO);
        MeasuredRunBuilder run =
                MeasuredRun.named("run")
                        .start(new KnownStart(start, Collections.nCopies(12, 1e-7)));
        for (int k = 0; k < SAMPLES; k++) {
            run.at(k * SPACING)
                    .position(measured[k], Double.NaN, Double.NaN)
                    .deviation(Channel.POSITION, noise, noise, noise);
        }
        return run.build();
    }

    private static double[] measured(double noise, Random random) {
        double[] measured = new double[SAMPLES];
        for (int k = 0; k < SAMPLES; k++) {
            measured[k] = travelled(DRAG, k * SPACING) + noise * random.nextGaussian();
        }
        return measured;
    }

    /** Of a mass of 1 kg: dv/dt = -c v. */
    private static double travelled(double drag, double time) {
        return SPEED * (1 - Math.exp(-drag * time)) / drag;
    }

    private static double cost(double[] measured, double drag, double noise) {
        double cost = 0;
        for (int k = 0; k < SAMPLES; k++) {
            double miss = (measured[k] - travelled(drag, k * SPACING)) / noise;
            cost += miss * miss;
        }
        return cost;
    }

    /** Of the drag, by central differences. */
    private static double information(double drag, double noise) {
        double information = 0;
        for (int k = 0; k < SAMPLES; k++) {
            double step = 1e-5;
            double slope =
                    (travelled(drag + step, k * SPACING) - travelled(drag - step, k * SPACING))
                            / (2 * step);
            information += slope * slope / (noise * noise);
        }
        return information;
    }
}
