package org.auvsim.diagnosis.genetic;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.genetic.Formula.Sample;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;

/** Forces that follow a known law are imitated by a formula, also where none was seen. */
class FormulaSearchTest {
    /** The law that is to be found. */
    private interface Law {
        double force(double[] variables);
    }

    private static List<Sample> samples(long seed, int count, Law law) {
        SplittableRandom lot = new SplittableRandom(seed);
        List<Sample> samples = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double[] variables = lot.doubles(10, -2, 2).toArray();
            variables[0] = 60 * lot.nextDouble();
            samples.add(new Sample(variables, law.force(variables)));
        }
        return samples;
    }

    private static Formula found(long seed, List<Sample> samples) {
        return new FormulaSearch(seed).found(samples, () -> true);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void aSpringAndADragAreImitated(long seed) {
        Law law = v -> -3 * v[2] - 2 * v[5] * Math.abs(v[5]);

        Formula found = found(seed, samples(seed, 90, law));

        assertThat(found.shareOf(samples(seed + 100, 90, law))).as(found.text()).isGreaterThan(0.9);
    }

    /** A force that goes with the pitch, the ninth of what is known. */
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2})
    void whatGoesWithTheOrientationIsImitated(long seed) {
        Law law = v -> 4 * v[8] * v[4];

        Formula found = found(seed, samples(seed, 90, law));

        assertThat(found.text()).contains("pitch");
        assertThat(found.shareOf(samples(seed + 100, 90, law))).as(found.text()).isGreaterThan(0.9);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void chanceIsNoLaw(long seed) {
        SplittableRandom lot = new SplittableRandom(seed);
        Law chance = _ -> lot.nextGaussian();

        Formula found = found(seed, samples(seed, 90, chance));

        assertThat(found.shareOf(samples(seed + 100, 90, chance))).isLessThan(0.2);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2})
    void theSameSeedGivesTheSameFormula(long seed) {
        List<Sample> samples = samples(seed, 40, v -> v[1] * v[4]);

        assertThat(found(seed, samples)).isEqualTo(found(seed, samples));
    }

    /** After three generations it is told to stop, and has the best of those. */
    @Test
    void aSearchThatIsStoppedMakesNoMoreGenerations() {
        List<Sample> samples = samples(1, 40, v -> v[1] * v[4]);
        AtomicInteger asked = new AtomicInteger();

        Formula best = new FormulaSearch(1).found(samples, () -> asked.incrementAndGet() <= 3);

        assertThat(asked).hasValue(4);
        assertThat(best.shareOf(samples)).isPositive();
    }
}
