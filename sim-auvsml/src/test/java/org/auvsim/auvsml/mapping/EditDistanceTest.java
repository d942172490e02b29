package org.auvsim.auvsml.mapping;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.Random;

class EditDistanceTest {
    @ParameterizedTest
    @CsvSource({
        "'', '', 0",
        "'', depth, 5",
        "depth, depth, 0",
        "kitten, sitting, 3",
        "saturday, sunday, 3",
        "form, from, 1",
        "letf, left, 1",
        "ca, abc, 3",
        "mass, masses, 2"
    })
    void wordsAreAsFarApartAsIsKnown(String one, String other, int distance) {
        assertThat(EditDistance.between(one, other)).isEqualTo(distance);
        assertThat(EditDistance.between(other, one)).isEqualTo(distance);
    }

    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {1, 2, 3})
    void itIsTheLeastThatTheDefinitionFinds(long seed) {
        Random random = new Random(seed);
        for (int i = 0; i < 50; i++) {
            String one = word(random);
            String other = word(random);
            assertThat(EditDistance.between(one, other))
                    .as("%s to %s", one, other)
                    .isEqualTo(defined(one, other));
        }
    }

    private static String word(Random random) {
        StringBuilder word = new StringBuilder();
        for (int left = random.nextInt(7); left > 0; left--) {
            word.append((char) ('a' + random.nextInt(3)));
        }
        return word.toString();
    }

    /** By trying all ways to begin. */
    private static int defined(String one, String other) {
        if (one.isEmpty() || other.isEmpty()) {
            return one.length() + other.length();
        }
        int replaced =
                defined(one.substring(1), other.substring(1))
                        + (one.charAt(0) == other.charAt(0) ? 0 : 1);
        int putIn = 1 + defined(one, other.substring(1));
        int takenOut = 1 + defined(one.substring(1), other);
        int least = Math.min(replaced, Math.min(putIn, takenOut));
        boolean isExchanged =
                one.length() > 1
                        && other.length() > 1
                        && one.charAt(0) == other.charAt(1)
                        && one.charAt(1) == other.charAt(0);
        return isExchanged
                ? Math.min(least, 1 + defined(one.substring(2), other.substring(2)))
                : least;
    }
}
