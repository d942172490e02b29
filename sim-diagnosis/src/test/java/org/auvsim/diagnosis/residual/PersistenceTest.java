package org.auvsim.diagnosis.residual;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.auvsml.run.LastingError;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.Random;
import java.util.function.IntToDoubleFunction;

class PersistenceTest {
    private static final int SAMPLES = 1000;
    private static final double INTERVAL = 0.04;
    private static final double NOISE = 0.05;

    /** Errors of which a share is left in the next row, of the size of the noise all in all. */
    private static IntToDoubleFunction errors(double kept, long seed) {
        Random random = new Random(seed);
        double[] errors = new double[SAMPLES];
        errors[0] = NOISE * random.nextGaussian();
        for (int k = 1; k < SAMPLES; k++) {
            double anew = Math.sqrt(1 - kept * kept) * NOISE * random.nextGaussian();
            errors[k] = kept * errors[k - 1] + anew;
        }
        return k -> errors[k];
    }

    private static Persistence of(IntToDoubleFunction motion, double kept) {
        return Persistence.of(
                List.of(
                        run(motion, errors(kept, 1), errors(kept, 2)),
                        run(motion, errors(kept, 3), errors(kept, 4))));
    }

    private static MeasuredRun run(
            IntToDoubleFunction motion, IntToDoubleFunction x, IntToDoubleFunction y) {
        MeasuredRunBuilder run = MeasuredRun.named("run");
        for (int k = 0; k < SAMPLES; k++) {
            run.at(INTERVAL * k)
                    .position(
                            motion.applyAsDouble(k) + x.applyAsDouble(k),
                            motion.applyAsDouble(k) - y.applyAsDouble(k),
                            Double.NaN);
        }
        return run.build();
    }

    private static IntToDoubleFunction counted(double step, double perRow) {
        return k -> step * Math.rint(3 * Math.sin(perRow * k) / step);
    }

    @Test
    void whatIsCountedInStepsIsOffFromOneToTheNext() {
        Persistence found =
                Persistence.of(List.of(run(k -> 0, counted(0.5, 0.02), counted(0.5, 0.6))));

        Persistence.Lasting lasting = found.of(Channel.POSITION, 0).orElseThrow();
        assertThat(Math.hypot(lasting.error().deviation(), lasting.anew()))
                .isCloseTo(0.5 / Math.sqrt(12), within(1e-9));
        double rowsPerStep = 0.5 / (3 * 0.02 * 2 / Math.PI);
        assertThat(lasting.error().time())
                .isCloseTo(rowsPerStep * INTERVAL / 2, within(0.1 * rowsPerStep * INTERVAL));
        assertThat(found.of(Channel.POSITION, 1)).isEmpty();
        assertThat(found.notice().orElseThrow())
                .contains(": those of the position, which is told in steps of 0.50 m, from step");
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.4, 0.5, 0.6, 0.7, 0.8})
    void errorsThatLastAreFound(double kept) {
        Persistence found = of(k -> 3 * Math.sin(0.02 * k), kept);

        for (int axis = 0; axis < 2; axis++) {
            Persistence.Lasting lasting = found.of(Channel.POSITION, axis).orElseThrow();
            LastingError error = lasting.error();
            double all = Math.hypot(error.deviation(), lasting.anew());
            double share = error.deviation() * error.deviation() / (all * all);
            assertThat(share * Math.exp(-INTERVAL / error.time())).isCloseTo(kept, within(0.15));
            assertThat(all).isCloseTo(NOISE, within(0.2 * NOISE));
        }
        assertThat(found.of(Channel.POSITION, 2)).isEmpty();
        assertThat(found.notice().orElseThrow())
                .startsWith("errors last from row to row, as the rows tell, and count as such:")
                .contains("those of the position about 0.");
    }

    /** In differences of far rows there is more motion, and still no error that lasts. */
    @ParameterizedTest
    @ValueSource(doubles = {0.01, 0.05, 0.1, 0.2, 0.5, 1, 2})
    void motionIsNone(double turn) {
        for (double size : new double[] {0.1, 1, 10, 100}) {
            assertThat(of(k -> size * Math.sin(turn * k), 0).errors()).as("%s m", size).isEmpty();
        }
    }

    /** One thousand runs without any. */
    @Test
    void noiseThatIsNewInEachRowIsNone() {
        for (long seed = 0; seed < 1000; seed++) {
            MeasuredRun run = run(_ -> 0, errors(0, 2 * seed), errors(0, 2 * seed + 1));
            assertThat(Persistence.of(List.of(run)).errors()).isEmpty();
        }
    }

    /** Rows that are unevenly far apart, or in steps, or have errors that are stated. */
    @Test
    void whatCannotBeToldIsNotSaid() {
        IntToDoubleFunction errors = errors(0.7, 1);
        MeasuredRunBuilder uneven = MeasuredRun.named("uneven");
        MeasuredRunBuilder counted = MeasuredRun.named("counted");
        MeasuredRunBuilder lasting = MeasuredRun.named("lasting");
        MeasuredRunBuilder stated = MeasuredRun.named("stated");
        lasting.lastingError(Channel.POSITION, 0, new LastingError(NOISE, 1));
        for (int k = 0; k < SAMPLES; k++) {
            double x = errors.applyAsDouble(k);
            uneven.at(INTERVAL * (k + 0.1 * (k % 3))).position(x, Double.NaN, Double.NaN);
            counted.at(INTERVAL * k)
                    .position(2 * NOISE * Math.rint(x / (2 * NOISE)), Double.NaN, Double.NaN);
            lasting.at(INTERVAL * k).position(x, Double.NaN, Double.NaN);
            stated.at(INTERVAL * k).position(x, Double.NaN, Double.NaN);
            stated.deviation(Channel.POSITION, NOISE, Double.NaN, Double.NaN);
        }
        for (MeasuredRunBuilder run : List.of(uneven, counted, lasting, stated)) {
            assertThat(Persistence.of(List.of(run.build())).errors()).isEmpty();
        }
    }

    /** Digits that are left out of the file are no matter; nor is an axis that is measured less. */
    @Test
    void axesMayBeMeasuredAtOtherTimesAndRounded() {
        IntToDoubleFunction x = errors(0.6, 11);
        IntToDoubleFunction y = errors(0.6, 12);
        MeasuredRunBuilder run = MeasuredRun.named("rounded");
        for (int k = 0; k < SAMPLES; k++) {
            double z = NOISE * Math.sin(k * k);
            run.at(INTERVAL * k)
                    .position(
                            Math.rint(1000 * x.applyAsDouble(k)) / 1000,
                            Math.rint(1000 * y.applyAsDouble(k)) / 1000,
                            k % 2 == 0 ? z : Double.NaN);
        }
        Persistence found = Persistence.of(List.of(run.build()));

        assertThat(found.errors()).extracting(Persistence.Lasting::axis).containsExactly(0, 1);
        assertThat(found.errors().getFirst().error().time()).isBetween(INTERVAL, 3 * INTERVAL);
    }

    /** Misses are whitened by what was found: none is told by the one before. */
    @Test
    void whatLastsIsTakenOutOfMisses() {
        MeasuredRun run = run(_ -> 0, errors(0.6, 7), errors(0.6, 8));
        Noise noise = Noise.of(List.of(run));
        Misses misses = new Misses(run, noise);

        double[] white = HeavyTailsTest.misses(misses, SAMPLES);
        double product = 0;
        for (int i = 2; i < white.length; i++) {
            product += white[i] * white[i - 2];
        }
        assertThat(product / Outcome.squares(white)).isCloseTo(0, within(0.08));
        assertThat(Whiteness.largest(List.of(white), List.of(misses))).isLessThan(Whiteness.LIMIT);
        assertThat(noise.of(Channel.POSITION)).isCloseTo(NOISE, within(0.2 * NOISE));
    }
}
