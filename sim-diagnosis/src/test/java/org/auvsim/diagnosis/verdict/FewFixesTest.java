package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

/** A glider whose depth is measured in each row, and where it is in a few of them. */
class FewFixesTest {
    private static final int SAMPLES = 200;
    private static final double OF_FIX = 0.5;
    private static final double OF_DEPTH = 0.01;

    private static BelievedModel glider() throws Exception {
        return Believed.model(
                """
                <scenario><time-step delta="0.05"/>
                  <world-object name="glider" mass="10"><sphere radius="0.2"/></world-object>
                </scenario>
                """,
                "glider");
    }

    /** It goes at 1 m/s along x, and sinks. */
    private static MeasuredRun run(long seed, int fixes, boolean isStated) {
        Random random = new Random(seed);
        MeasuredRunBuilder run = MeasuredRun.named("run" + seed);
        for (int k = 0; k < SAMPLES; k++) {
            boolean isFix = k % (SAMPLES / fixes) == 0;
            double x = 0.1 * k + OF_FIX * random.nextGaussian();
            double y = OF_FIX * random.nextGaussian();
            run.at(0.1 * k)
                    .position(
                            isFix ? x : Double.NaN,
                            isFix ? y : Double.NaN,
                            -0.02 * k + OF_DEPTH * random.nextGaussian());
            if (isFix && isStated) {
                run.deviation(Channel.POSITION, OF_FIX, OF_FIX, Double.NaN);
            }
        }
        return run.build();
    }

    private static Noise noise(int runs, int fixes, boolean isStated) {
        return Noise.of(
                IntStream.range(0, runs).mapToObj(seed -> run(seed, fixes, isStated)).toList());
    }

    private static void assertDepthIsKnown(Noise noise) {
        assertThat(noise.of(Channel.POSITION, 2)).isCloseTo(OF_DEPTH, within(0.002));
    }

    /** They would weigh as if they were exact. */
    @Test
    void twoOrThreeNumbersARunAreNoMeasurement() {
        for (int fixes : List.of(2, 4)) {
            Noise noise = noise(3, fixes, false);

            assertThat(noise.tells(Channel.POSITION, 0)).isFalse();
            assertThat(noise.tells(Channel.POSITION, 1)).isFalse();
            assertDepthIsKnown(noise);
            assertThat(new Misses(run(0, fixes, false), noise).rows())
                    .containsExactly(new Misses.Row(Channel.POSITION, 2));
        }
    }

    @Test
    void theyCountAsTheirDeviationsState() {
        Noise noise = noise(3, 2, true);

        assertThat(noise.of(Channel.POSITION, 0)).isCloseTo(OF_FIX, within(1e-12));
        assertThat(noise.of(Channel.POSITION, 1)).isCloseTo(OF_FIX, within(1e-12));
        assertDepthIsKnown(noise);
    }

    /** Three runs of eight fixes have fifteen third differences. */
    @Test
    void allRunsTogetherMayHaveEnough() {
        Noise noise = noise(3, 8, false);

        assertThat(noise.of(Channel.POSITION, 0)).isBetween(OF_FIX / 3, 3 * OF_FIX);
        assertDepthIsKnown(noise);
    }

    /** Of parts with three fixes each none has a third difference. */
    @Test
    void partsHaveTheNoiseOfTheirRun() {
        MeasuredRun run = run(1, 20, false);
        List<MeasuredRun> parts = List.of(run.part("a", 0, 25), run.part("b", 30, 59));

        Noise noise = Noise.of(parts);

        assertThat(noise.of(Channel.POSITION, 0))
                .isEqualTo(Noise.of(List.of(run)).of(Channel.POSITION, 0));
        assertThat(noise.of(Channel.POSITION, 2))
                .as("by their own 56 rows")
                .isCloseTo(OF_DEPTH, withinPercentage(30));
    }

    @Test
    void aNoticeTellsOfThem() throws Exception {
        List<MeasuredRun> fit = List.of(run(1, 2, false), run(2, 2, false));
        List<MeasuredRun> heldOut = List.of(run(3, 2, false));

        assertThat(Believed.suspectedOf("mass_error", glider(), fit, heldOut).notices())
                .containsExactly(
                        "too few numbers to tell their noise, so treated as not measured unless"
                                + " their standard deviations are stated (as sd_x): position x,"
                                + " position y");
    }
}
