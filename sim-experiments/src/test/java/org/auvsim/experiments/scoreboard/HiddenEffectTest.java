package org.auvsim.experiments.scoreboard;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.experiments.hidden.CaseBook;
import org.auvsim.experiments.hidden.CaseKind;
import org.auvsim.experiments.hidden.HiddenCase;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is hidden in measured runs is named, with its numbers, and foretells others. */
class HiddenEffectTest {
    /** Of the model's error on held-out runs, 1 if nothing was gained. */
    private static final double MOST_ERROR_LEFT = 0.15;

    /** Relative, in parts of the noise. */
    private static final double MOST_PARAMETER_ERROR = 20;

    @ParameterizedTest(name = "noise {0}, seed {1}")
    @CsvSource({"0.01, 12", "0.01, 16", "0.01, 18", "0.01, 61014", "0.01, 4113"})
    void anEffectOfTheLibraryIsNamed(double noise, long seed) {
        HiddenCase of = CaseBook.draw(CaseKind.SINGLE, noise, seed);
        Outcome outcome = right(of);
        assertThat(outcome.parameterErrors())
                .as(of.toString())
                .isNotEmpty()
                .allMatch(e -> e < MOST_PARAMETER_ERROR * noise);
        assertThat(outcome.errorLeft()).as(of.toString()).isLessThan(MOST_ERROR_LEFT);
    }

    /** What only falls has too little mass or too much drag; pushed aside it tells which. */
    @ParameterizedTest(name = "noise {0}, seed {1}")
    @CsvSource({"0.01, 72033", "0.01, 72027"})
    void whatRunsCannotTellApartIsTold(double noise, long seed) {
        right(CaseBook.draw(CaseKind.ALIAS, noise, seed));
    }

    @ParameterizedTest(name = "noise {0}, seed {1}")
    @CsvSource("0.01, 3")
    void bothOfAPairAreNamedAndNothingElse(double noise, long seed) {
        HiddenCase of = CaseBook.draw(CaseKind.PAIR, noise, seed);
        assertThat(right(of).errorLeft()).as(of.toString()).isLessThan(MOST_ERROR_LEFT);
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
}
