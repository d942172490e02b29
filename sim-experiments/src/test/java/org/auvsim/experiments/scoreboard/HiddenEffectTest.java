package org.auvsim.experiments.scoreboard;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.experiments.hidden.CaseBook;
import org.auvsim.experiments.hidden.CaseKind;
import org.auvsim.experiments.hidden.HiddenCase;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * What is hidden in measured runs is named, with its numbers, and foretells others. Each case
 * states how far off its numbers may be, and how much of the error on held-out runs may be left:
 * about a third more than is.
 */
class HiddenEffectTest {
    @ParameterizedTest(name = "noise {0}, seed {1}")
    @CsvSource({
        "0.01, 12, 0.11, 0.095",
        "0.01, 16, 0.015, 0.015",
        "0.01, 18, 0.03, 0.015",
        "0.01, 61014, 0.06, 0.06",
        "0.01, 4113, 0.13, 0.13",
        "0.001, 61014, 0.006, 0.007",
        "0.05, 16, 0.08, 0.08",
        "0.05, 120004, 0.36, 0.2"
    })
    void anEffectOfTheLibraryIsNamed(double noise, long seed, double parameters, double left) {
        HiddenCase of = CaseBook.draw(CaseKind.SINGLE, noise, seed);
        Outcome outcome = right(of);
        assertThat(outcome.parameterErrors())
                .as("%s: errors of numbers. To repeat it: %s", of, of.repeat())
                .isNotEmpty()
                .allMatch(e -> e < parameters);
        foretells(of, outcome, left);
    }

    /** What only falls has too little mass or too much drag; pushed aside it tells which. */
    @ParameterizedTest(name = "noise {0}, seed {1}")
    @CsvSource({"0.01, 72033", "0.01, 72027"})
    void whatRunsCannotTellApartIsTold(double noise, long seed) {
        right(CaseBook.draw(CaseKind.ALIAS, noise, seed));
    }

    @ParameterizedTest(name = "noise {0}, seed {1}")
    @CsvSource({"0.01, 3, 0.03", "0.05, 120008, 0.015"})
    void bothOfAPairAreNamedAndNothingElse(double noise, long seed, double left) {
        HiddenCase of = CaseBook.draw(CaseKind.PAIR, noise, seed);
        foretells(of, right(of), left);
    }

    @ParameterizedTest(name = "noise {0}, seed {1}")
    @CsvSource({"0.01, 5", "0.01, 15", "0.01, 22"})
    void whereNothingIsHiddenNothingIsNamed(double noise, long seed) {
        right(CaseBook.draw(CaseKind.NULL, noise, seed));
    }

    @ParameterizedTest(name = "noise {0}, seed {1}")
    @CsvSource("0.05, 4204")
    void whatNoCauseCoversStaysUnexplained(double noise, long seed) {
        right(CaseBook.draw(CaseKind.UNCOVERED, noise, seed));
    }

    private static Outcome right(HiddenCase of) {
        Outcome outcome = Scoreboard.outcome(of);
        assertThat(outcome.isRight())
                .as("%s: said %s. To repeat it: %s", of, outcome.said(), of.repeat())
                .isTrue();
        return outcome;
    }

    private static void foretells(HiddenCase of, Outcome outcome, double left) {
        assertThat(outcome.errorLeft())
                .as("%s: held-out error left. To repeat it: %s", of, of.repeat())
                .isLessThan(left);
    }
}
