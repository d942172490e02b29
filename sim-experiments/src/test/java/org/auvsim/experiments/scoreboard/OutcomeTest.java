package org.auvsim.experiments.scoreboard;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.Method;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.experiments.hidden.CaseKind;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.List;

class OutcomeTest {
    private static Outcome outcome(Verdict verdict, boolean first, AliasTold alias) {
        return new Outcome(
                Method.SHOOTING,
                CaseKind.ALIAS,
                0.01,
                1,
                "sled",
                List.of("mass_error"),
                new Answer(verdict, List.of()),
                first,
                first,
                List.of(),
                List.of(),
                0,
                0,
                0.01,
                alias,
                List.of(),
                false,
                1,
                "");
    }

    /** Where the data tells two causes apart, one that finds nothing is not right. */
    @ParameterizedTest(name = "alike {0}, told so {1}, {2}, right one first {3}: right {4}")
    @CsvSource({
        "true, true, EXPLAINED, true, true",
        "true, true, EXPLAINED, false, true",
        "true, false, EXPLAINED, true, false",
        "false, false, EXPLAINED, true, true",
        "false, true, EXPLAINED, true, false",
        "false, false, EXPLAINED, false, false",
        "false, false, UNEXPLAINED, false, false",
        "false, false, NONE, false, false"
    })
    void anAliasIsRightWhereTheRightIsNamed(
            boolean alike, boolean told, Verdict verdict, boolean first, boolean right) {
        Outcome outcome = outcome(verdict, first, new AliasTold(alike, told));

        assertThat(outcome.isRight()).isEqualTo(right);
    }
}
