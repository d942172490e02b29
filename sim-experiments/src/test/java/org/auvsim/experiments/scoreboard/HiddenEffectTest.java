package org.auvsim.experiments.scoreboard;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.result.Alternative;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.experiments.hidden.CaseBook;
import org.auvsim.experiments.hidden.CaseKind;
import org.auvsim.experiments.hidden.HiddenCase;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.List;

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

    /** A ball of 0.4 of the mass falls as one of 2.5 times the drag: only their ratio counts. */
    @Test
    void theMassOfABallThatFallsIsToldBesideItsDrag() {
        HiddenCase of = CaseBook.draw(CaseKind.SINGLE, 0.01, 23);
        Diagnosis diagnosis =
                new Investigation(
                                of.model(),
                                of.fit(),
                                of.heldOut(),
                                Library.of(of.model(), of.fit()),
                                1,
                                Progress.SILENT)
                        .diagnose();
        assertThat(diagnosis.selected())
                .extracting(Finding::cause)
                .containsExactly("quadratic_drag");
        assertThat(diagnosis.alternatives())
                .filteredOn(Alternative::isIndistinguishable)
                .extracting(Alternative::causes)
                .contains(List.of("mass_error"));
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
