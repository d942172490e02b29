package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Knowledge;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.Axis;
import org.auvsim.diagnosis.result.Discrepancy;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.diagnosis.subject.FreeSphere;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

class MisfitTest {
    private static final double INTERVAL = 0.5;

    private static double[] times(int samples) {
        return IntStream.range(0, samples).mapToDouble(k -> INTERVAL * k).toArray();
    }

    private static double[] swing(double[] times, double frequency) {
        return IntStream.range(0, times.length)
                .mapToDouble(k -> Math.sin(2 * Math.PI * frequency * times[k]))
                .toArray();
    }

    /** Four turns within 16 samples, of which the last is followed by no interval. */
    @Test
    void aFrequencyIsThatOfTheSwing() {
        double frequency = 4 / (16 * INTERVAL);

        for (int samples : List.of(16, 20)) {
            double[] times = times(samples);
            assertThat(Misfit.frequency(swing(times, frequency), times).orElseThrow())
                    .isCloseTo(frequency, within(1e-12));
        }
    }

    @Test
    void whatDoesNotSwingHasNone() {
        assertThat(Misfit.frequency(new double[16], times(16))).isEmpty();
    }

    /** As if a fix of the position were lost for half of the time. */
    @Test
    void numbersWithALongGapHaveNone() {
        double[] times = times(16);
        for (int k = 8; k < times.length; k++) {
            times[k] += 16 * INTERVAL;
        }

        assertThat(Misfit.frequency(swing(times(16), 4 / (16 * INTERVAL)), times)).isEmpty();
    }

    /** x swings by a metre at 0.1 Hz, y is off by half as much: with as much noise each. */
    private static MeasuredRun run(int rowsPerFix) {
        Random random = new Random(5);
        MeasuredRunBuilder run = MeasuredRun.named("fixes");
        for (int k = 0; k < 700; k++) {
            double x = k % rowsPerFix == 0 ? Math.sin(2 * Math.PI * 0.1 * 0.1 * k) : Double.NaN;
            run.at(0.1 * k).position(x, 0.5 * random.nextGaussian(), Double.NaN);
            run.deviation(Channel.POSITION, 0.01, 0.01, 0.01);
        }
        return run.build();
    }

    /** The largest misfit of a body that stays where it is. */
    private static Discrepancy largest(MeasuredRun run) throws Exception {
        RigidMotion still = new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);
        Fit fit =
                new Fit(
                        Stepping.exact(FreeSphere.believed(0.1)),
                        List.of(new Misses(run, Noise.of(List.of(run)))),
                        Hypothesis.NONE,
                        List.of(List.of(new Window(0, run.size() - 1, still))),
                        Knowledge.NONE);
        return Misfit.largest(Judged.of(fit), 0);
    }

    /** It is as far off as one that is measured in every row; rows without it tell nothing. */
    @Test
    void whatIsMeasuredInSomeRowsOnlyIsNotDiluted() throws Exception {
        Discrepancy misfit = largest(run(10));

        assertThat(misfit.axis()).isEqualTo(new Axis(Frame.WORLD, 'x'));
        assertThat(misfit.frequency().orElseThrow()).isCloseTo(0.1, within(0.01));
        assertThat(misfit.time() % 1).isCloseTo(0, within(1e-9));
        assertThat(largest(run(1)).frequency().orElseThrow()).isCloseTo(0.1, within(0.01));
    }

    @Test
    void anAxisOfTheBodyIsToldAsOne() throws Exception {
        Random random = new Random(5);
        MeasuredRunBuilder run = MeasuredRun.named("log").frame(Channel.VELOCITY, Frame.BODY);
        for (int k = 0; k < 100; k++) {
            double noise = 0.01 * random.nextGaussian();
            run.at(0.1 * k).measured(Channel.VELOCITY, Double.NaN, 1 + noise, Double.NaN);
        }

        assertThat(largest(run.build()).axis()).isEqualTo(new Axis(Frame.BODY, 'y'));
    }
}
