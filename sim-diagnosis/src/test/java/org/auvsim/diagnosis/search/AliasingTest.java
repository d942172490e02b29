package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.FreeSphere;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.Random;

/**
 * Runs at different times of one clock: by the phases in which they begin, a swing at a frequency
 * that is off by a turn from one run to the next looks much like the true one.
 */
class AliasingTest {
    private static final double FORCE = 0.2;
    private static final double PHASE = 1.1;
    private static final double NOISE = 0.02;

    /** Of a kilogram on which only this force acts, by its two integrals. */
    private static MeasuredRun run(double omega, double begin, double speed, Random random) {
        MeasuredRunBuilder run = MeasuredRun.named("run at " + begin);
        double there = begin * omega + PHASE;
        double amplitude = FORCE / omega;
        for (int k = 0; k <= 200; k++) {
            double t = 0.1 * k;
            double swung = amplitude * (Math.cos(there) * t);
            swung -= amplitude / omega * (Math.sin(there + omega * t) - Math.sin(there));
            run.at(begin + t)
                    .position(
                            speed * t + swung + NOISE * random.nextGaussian(),
                            NOISE * random.nextGaussian(),
                            NOISE * random.nextGaussian());
        }
        return run.build();
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.85, 1.3})
    void theFrequencyOfAllRunsTogetherIsFound(double omega) throws Exception {
        BelievedModel model = FreeSphere.believed(0.1);
        Random random = new Random(7);
        List<MeasuredRun> runs =
                List.of(
                        run(omega, 0, 0.3, random),
                        run(omega, 80, -0.2, random),
                        run(omega, 160, 0.1, random));
        List<Cause> periodic =
                Library.of(model, runs).stream()
                        .filter(cause -> cause.id().equals("periodic_force"))
                        .toList();

        Hypothesis found =
                new Search(model, runs, periodic, Way.THOROUGH, new Course(Progress.SILENT))
                        .found()
                        .best()
                        .fit()
                        .hypothesis();

        List<Quantity> told = periodic.getFirst().quantities(found.theta().getFirst());
        assertThat(told.getFirst().value()).isCloseTo(FORCE, within(0.002));
        assertThat(told.get(3).value()).isCloseTo(omega, within(0.001));
        assertThat(told.get(4).value()).isCloseTo(PHASE, within(0.05));
    }
}
