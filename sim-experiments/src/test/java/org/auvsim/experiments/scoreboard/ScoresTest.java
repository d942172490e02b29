package org.auvsim.experiments.scoreboard;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.Method;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.experiments.hidden.CaseKind;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;

class ScoresTest {
    private static final double LOST = Double.POSITIVE_INFINITY;

    private static Outcome outcome(CaseKind kind, double errorLeft) {
        return new Outcome(
                Method.SHOOTING,
                kind,
                0.01,
                1,
                "ball",
                List.of("linear_drag"),
                new Answer(Verdict.EXPLAINED, List.of("linear_drag")),
                true,
                true,
                List.of(),
                List.of(),
                0,
                0,
                errorLeft,
                AliasTold.NONE,
                List.of(),
                false,
                1,
                "");
    }

    private static double errorLeft(double... left) {
        List<Outcome> outcomes =
                DoubleStream.concat(DoubleStream.of(Double.NaN), DoubleStream.of(left))
                        .mapToObj(
                                of ->
                                        outcome(
                                                Double.isNaN(of) ? CaseKind.NULL : CaseKind.SINGLE,
                                                of))
                        .toList();
        return Scores.of(0.01, Method.SHOOTING, outcomes).errorLeft();
    }

    /** The median of three, one of which is lost, is the larger of the others. */
    @Test
    void aPredictionThatGetsLostIsWorseThanAllOthers() {
        assertThat(errorLeft(0.1, 0.2, LOST)).isEqualTo(0.2);
        assertThat(errorLeft(0.1, LOST, LOST)).isEqualTo(LOST);
        assertThat(errorLeft(0.1, LOST)).isEqualTo(LOST);
        assertThat(errorLeft(0.1, 0.3)).isEqualTo(0.2);
        assertThat(errorLeft()).isNaN();
    }

    @Test
    void whatGetsLostIsNotExcusedByABelievedModelThatDoes() {
        assertThat(Referee.left(4, 1)).isEqualTo(0.5);
        assertThat(Referee.left(LOST, 1)).isZero();
        assertThat(Referee.left(4, LOST)).isEqualTo(LOST);
        assertThat(Referee.left(LOST, LOST)).isEqualTo(LOST);
    }

    /** JSON has no infinite numbers. */
    @Test
    void anInfiniteFigureIsNullForMachines() {
        Scores lost = Scores.of(0.01, Method.SHOOTING, List.of(outcome(CaseKind.SINGLE, LOST)));

        assertThat(Figure.ERROR_LEFT.of(lost)).isEqualTo("Infinity");
        assertThat(Figure.ERROR_LEFT.forMachines(lost).get("value")).isEqualTo(Optional.empty());
    }
}
