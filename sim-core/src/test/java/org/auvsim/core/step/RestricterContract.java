package org.auvsim.core.step;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;

/** What every {@link TimeStepRestricter} keeps; extend it to test one of your own. */
public abstract class RestricterContract {
    /** The restricter, made to cope with speeds of up to 10 m/s and radii from 0.05 m. */
    protected abstract TimeStepRestricter restricter();

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
    void theStepIsAboveZeroAndAtMostWhatIsWanted(long seed) {
        for (double wanted : new double[] {1e-6, 0.01, 0.05, 1}) {
            double dt = restricter().restrict(Scene.crowd(seed), wanted);

            assertThat(dt).isGreaterThan(0).isLessThanOrEqualTo(wanted);
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {11, 12, 13})
    void restrictingMovesNothingAndIsRepeatable(long seed) {
        Motion motion = Scene.crowd(seed);
        List<Vec3> before = Scene.positions(motion);

        double first = restricter().restrict(motion, 0.5);
        double second = restricter().restrict(motion, 0.5);

        assertThat(second).isEqualTo(first);
        assertThat(Scene.positions(motion)).isEqualTo(before);
    }

    @Test
    void anEmptyWorldKeepsTheStep() {
        assertThat(restricter().restrict(Scene.of(), 0.05)).isEqualTo(0.05);
    }
}
