package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.apache.commons.math3.ode.FirstOrderDifferentialEquations;
import org.apache.commons.math3.ode.nonstiff.DormandPrince853Integrator;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
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

/** A sphere of 1 kg flies past a magnet, whose place and strength lie in a long valley. */
class DescentTest {
    private static final double[] SOURCE = {4, 5, 2};
    private static final double STRENGTH = 40;
    private static final double NOISE = 1e-4;
    private static final double SPACING = 0.05;
    private static final int SAMPLES = 121;

    @ParameterizedTest(name = "from ({0}, {1}, {2})")
    @CsvSource({"4.5, 7, 3", "2, 9, 2", "4, 8, -1", "0, 4, 4"})
    void itArrivesAlongACurvedValley(double x, double y, double z) throws Exception {
        BelievedModel model = FreeSphere.believed(0.02);
        MeasuredRun run = run();
        Cause magnet =
                Library.of(model, List.of(run)).stream()
                        .filter(cause -> cause.id().equals("magnetic"))
                        .findFirst()
                        .orElseThrow();
        Noise noise = Noise.of(List.of(run));
        List<Misses> data = Misses.of(List.of(run), noise);
        Hypothesis far = new Hypothesis(List.of(magnet), List.of(new double[] {x, y, z, 0.05}));
        Fit start = Following.of(Stepping.exact(model), far, data, noise).whole();

        Hypothesis arrived = Descent.of(start).steps(20).fit().hypothesis();

        List<Quantity> found = magnet.quantities(arrived.theta().getFirst());
        for (int axis = 0; axis < 3; axis++) {
            assertThat(found.get(axis).value()).isCloseTo(SOURCE[axis], within(0.02));
        }
        assertThat(found.get(3).value()).isCloseTo(STRENGTH, within(0.02 * STRENGTH));
    }

    private static MeasuredRun run() {
        Random random = new Random(5);
        RigidMotion start =
                new RigidMotion(Vec3.ZERO, Quat.IDENTITY, new Vec3(1.2, 0.3, 0), Vec3.ZERO);
        MeasuredRunBuilder run =
                MeasuredRun.named("run")
                        .start(new KnownStart(start, Collections.nCopies(12, 1e-9)));
        for (int k = 0; k < SAMPLES; k++) {
            double[] at = motion(k * SPACING);
            run.at(k * SPACING)
                    .position(
                            at[0] + NOISE * random.nextGaussian(),
                            at[1] + NOISE * random.nextGaussian(),
                            at[2] + NOISE * random.nextGaussian());
        }
        return run.build();
    }

    private static double[] motion(double time) {
        double[] y = {0, 0, 0, 1.2, 0.3, 0};
        if (time > 0) {
            new DormandPrince853Integrator(1e-6, 0.1, 1e-11, 1e-11)
                    .integrate(new Flight(), 0, y, time, y);
        }
        return y;
    }

    /** F = s d / |d|^5, d from the sphere to the magnet. */
    private static final class Flight implements FirstOrderDifferentialEquations {
        @Override
        public int getDimension() {
            return 6;
        }

        @Override
        public void computeDerivatives(double t, double[] y, double[] rates) {
            double square = 0;
            for (int i = 0; i < 3; i++) {
                square += (SOURCE[i] - y[i]) * (SOURCE[i] - y[i]);
            }
            for (int i = 0; i < 3; i++) {
                rates[i] = y[3 + i];
                rates[3 + i] = STRENGTH * (SOURCE[i] - y[i]) / Math.pow(square, 2.5);
            }
        }
    }
}
