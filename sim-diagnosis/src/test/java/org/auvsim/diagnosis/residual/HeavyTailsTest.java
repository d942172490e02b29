package org.auvsim.diagnosis.residual;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.Sensing;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

class HeavyTailsTest {
    private static final int SAMPLES = 400;
    private static final double NOISE = 0.02;

    /** Two coordinates with noise, the first of which is far off every so often. */
    private static MeasuredRun run(int every) {
        Random random = new Random(3);
        MeasuredRunBuilder run = MeasuredRun.named("dive");
        for (int k = 0; k < SAMPLES; k++) {
            double astray = k % every == every / 2 ? 30 * NOISE : 0;
            run.at(0.1 * k)
                    .position(
                            Math.sin(0.1 * k) + astray + NOISE * random.nextGaussian(),
                            0.2 * k + NOISE * random.nextGaussian(),
                            Double.NaN);
        }
        return run.build();
    }

    /** Those of a body that stays at the origin. */
    private static double[] misses(Misses of) {
        return misses(of, SAMPLES);
    }

    static double[] misses(Misses of, int samples) {
        RigidMotion[] still = new RigidMotion[samples];
        Arrays.fill(still, new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO));
        return of.of(still, Sensing.EXACT, 0, samples);
    }

    private static Misses.Row x() {
        return new Misses.Row(Channel.POSITION, 0);
    }

    private static Misses.Row y() {
        return new Misses.Row(Channel.POSITION, 1);
    }

    @Test
    void whatIsFarOffIsToldAndCountsLess() {
        MeasuredRun run = run(50);
        Noise noise = Noise.of(List.of(run));

        assertThat(HeavyTails.notice(run, List.of(x(), y()), noise).orElseThrow())
                .matches(
                        "dive: outliers, given less weight and left out of errors: [0-9]+ of 400"
                                + " numbers of position x");
        double[] tamed = misses(Misses.of(List.of(run), noise).getFirst());
        double[] plain = misses(new Misses(run, noise));
        assertThat(Math.abs(tamed[2 * 25])).isLessThan(0.2 * Math.abs(plain[2 * 25]));
        assertThat(tamed[2 * 25 + 1]).isEqualTo(plain[2 * 25 + 1]);
    }

    @Test
    void speedsAlongTheVehicleAreToldAsSuch() {
        Random random = new Random(3);
        MeasuredRunBuilder dive = MeasuredRun.named("dive").frame(Channel.VELOCITY, Frame.BODY);
        for (int k = 0; k < SAMPLES; k++) {
            double astray = k % 50 == 25 ? 30 * NOISE : 0;
            double noise = NOISE * random.nextGaussian();
            dive.at(0.1 * k).measured(Channel.VELOCITY, Math.sin(0.1 * k) + astray + noise, 0, 0);
        }
        MeasuredRun run = dive.build();
        List<Misses.Row> rows = List.of(new Misses.Row(Channel.VELOCITY, 0));

        assertThat(HeavyTails.notice(run, rows, Noise.of(List.of(run))).orElseThrow())
                .endsWith("numbers of velocity along the body's x (ahead)");
    }

    /** Near the beginning, of a fix a second; two with two between them are told as these. */
    @ParameterizedTest(name = "{0} and {1}")
    @CsvSource({"3, 4", "20, 21", "10, 13"})
    void twoThatAreOffAreToldAndNotThoseBesideThem(int one, int other) {
        Random random = new Random(8);
        MeasuredRunBuilder dive = MeasuredRun.named("dive");
        for (int k = 0; k < 40; k++) {
            double astray = k == one ? -23 : k == other ? -18 : 0;
            dive.at(k)
                    .position(
                            5 * Math.sin(0.2 * k) + astray + 0.15 * random.nextGaussian(),
                            Double.NaN,
                            Double.NaN);
        }
        MeasuredRun run = dive.build();

        Misses tamed = Misses.of(List.of(run), Noise.of(List.of(run))).getFirst();

        assertThat(IntStream.range(0, 40).filter(k -> !tamed.counts(k)))
                .containsExactly(one, other);
    }

    @Test
    void neighboursOfARowThatLacksAreNoOutliers() {
        Random random = new Random(3);
        MeasuredRunBuilder dive = MeasuredRun.named("dive");
        for (int k = 0; k < SAMPLES; k++) {
            if (k % 100 != 50) {
                dive.at(0.1 * k)
                        .position(
                                0.2 * k * k + NOISE * random.nextGaussian(),
                                NOISE * random.nextGaussian(),
                                Double.NaN);
            }
        }
        MeasuredRun run = dive.build();

        assertThat(HeavyTails.notice(run, List.of(x(), y()), Noise.of(List.of(run)))).isEmpty();
    }

    /** A fix in some rows only, while the body goes round faster than these can follow. */
    @Test
    void aMotionThatBendsIsNoOutlier() {
        Random random = new Random(9);
        MeasuredRunBuilder round = MeasuredRun.named("dive");
        for (int k = 0; k < SAMPLES; k++) {
            double a = k < SAMPLES / 4 ? 0.7 * k : 0.7 * SAMPLES / 4;
            round.at(k).position(Math.cos(a) + NOISE * random.nextGaussian(), 0, Double.NaN);
        }
        MeasuredRun run = round.build();

        assertThat(HeavyTails.notice(run, List.of(x()), Noise.of(List.of(run)))).isEmpty();
    }

    /**
     * A fix whose quality varies, and says so: every seventh number is ten times as far off as the
     * others are.
     *
     * @param of what it says, as a share of what is so
     * @param astray by how many of its deviations one number is off
     */
    private static MeasuredRun stated(double of, double astray) {
        Random random = new Random(4);
        MeasuredRunBuilder dive = MeasuredRun.named("dive");
        for (int k = 0; k < SAMPLES; k++) {
            double sigma = k % 7 == 3 ? 10 * NOISE : NOISE;
            double off = (k == 201 ? astray : 0) + random.nextGaussian();
            dive.at(0.1 * k).position(Math.sin(0.1 * k) + sigma * off, 0, Double.NaN);
            dive.deviation(Channel.POSITION, of * sigma, Double.NaN, Double.NaN);
        }
        return dive.build();
    }

    @Test
    void whatIsStatedToBeFarOffIsNoOutlier() {
        for (double of : new double[] {0.3, 1, 3}) {
            MeasuredRun run = stated(of, 0);
            Noise noise = Noise.of(List.of(run));

            assertThat(HeavyTails.notice(run, List.of(x()), noise)).as("%s", of).isEmpty();
            assertThat(misses(Misses.of(List.of(run), noise).getFirst()))
                    .isEqualTo(misses(new Misses(run, noise)));
        }
    }

    @Test
    void whatIsFurtherOffThanStatedIsAnOutlier() {
        MeasuredRun run = stated(1, 30);

        assertThat(HeavyTails.notice(run, List.of(x()), Noise.of(List.of(run))).orElseThrow())
                .endsWith(": 1 of 400 numbers of position x");
    }

    @Test
    void noiseHasNoOutliers() {
        MeasuredRun run = run(2 * SAMPLES + 2);

        assertThat(HeavyTails.notice(run, List.of(x(), y()), Noise.of(List.of(run)))).isEmpty();
    }
}
