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

    @ParameterizedTest(name = "{0}, noise {1}, seed {2}")
    @CsvSource({
        "single, 0.01, 12",
        "single, 0.01, 16",
        "single, 0.01, 18",
        "single, 0.01, 23",
    })
    void anEffectOfTheLibraryIsNamed(String kind, double noise, long seed) {
        HiddenCase of = CaseBook.draw(CaseKind.SINGLE, noise, seed);
        Outcome outcome = right(of);
        assertThat(outcome.parameterErrors())
                .as(of.toString())
                .isNotEmpty()
                .allMatch(e -> e < 20 * noise);
        assertThat(outcome.errorLeft()).as(of.toString()).isLessThan(MOST_ERROR_LEFT);
    }

    private static Outcome right(HiddenCase of) {
        Outcome outcome = Scoreboard.outcome(of);
        assertThat(outcome.isRight())
                .as("%s: said %s. To repeat it: %s", of, outcome.said(), of.repeat())
                .isTrue();
        return outcome;
    }
}
