package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.diagnosis.subject.FreeSphere;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.Random;

/** Spheres that coast, of which one run may be measured worse. */
class NoisierRunsTest {
    private static final double USUAL = 0.01;
    private static final int SAMPLES = 400;

    private static MeasuredRun run(String name, double noise, int samples, boolean isStated) {
        Random random = new Random(name.hashCode());
        MeasuredRunBuilder run = MeasuredRun.named(name);
        for (int k = 0; k < samples; k++) {
            double t = 0.1 * k;
            run.at(t).position(t + noise * random.nextGaussian(), Double.NaN, Double.NaN);
            if (isStated) {
                run.deviation(Channel.POSITION, noise, Double.NaN, Double.NaN);
            }
        }
        return run.build();
    }

    private static List<String> notices(MeasuredRun other) throws Exception {
        BelievedModel model = FreeSphere.believed(0.05);
        return Believed.suspectedOf(
                        "linear_drag",
                        model,
                        List.of(run("a", USUAL, SAMPLES, false), other),
                        List.of(run("c", USUAL, SAMPLES, false)))
                .notices()
                .stream()
                .filter(notice -> notice.contains("times the noise"))
                .toList();
    }

    @Test
    void aRunOfThreeTimesTheNoiseIsNamed() throws Exception {
        assertThat(notices(run("b", 3 * USUAL, SAMPLES, false)))
                .singleElement()
                .asString()
                .matches(
                        "b: position x has [23]\\.\\d times the noise of the other"
                                + " runs \\(0\\.0\\d+ m against 0\\.0\\d+ m\\), but one noise is"
                                + " taken for all: state the standard deviations in all runs \\(as"
                                + " sd_x\\)");
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 1.5})
    void lessIsNotWorthAWord(double times) throws Exception {
        assertThat(notices(run("b", times * USUAL, SAMPLES, false))).isEmpty();
    }

    /** Twenty rows may be as far off by chance. */
    @Test
    void aShortRunMayBeSoByChance() throws Exception {
        assertThat(notices(run("b", 3 * USUAL, 20, false))).isEmpty();
    }

    @Test
    void whatStatesItsDeviationsIsTakenByThem() throws Exception {
        assertThat(notices(run("b", 3 * USUAL, SAMPLES, true))).isEmpty();
    }
}
