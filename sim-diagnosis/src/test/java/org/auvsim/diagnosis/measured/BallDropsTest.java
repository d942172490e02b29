package org.auvsim.diagnosis.measured;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Alternative;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;
import java.util.Objects;

/** Balls that fall from a bridge, twice each: the first drop is fitted, the second held out. */
@Tag("measured-data")
class BallDropsTest {
    private final DataSet data = DataSet.named("ball-drops");

    private Diagnosis diagnosis(String ball) throws Exception {
        BelievedModel model = data.model("balls.xml", ball.replace('_', ' '));
        return data.diagnosis(model, "columns.xml", List.of(data.file(ball + ".csv")), List.of());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "whiffle_ball_1",
                "whiffle_ball_2",
                "orange_whiffle_ball",
                "yellow_whiffle_ball"
            })
    void aLightBallHasDragOfALawThatIsNotSettled(String ball) throws Exception {
        Diagnosis diagnosis = diagnosis(ball);

        isDrag(diagnosis);
        assertThat(diagnosis.sentence())
                .contains("the drag law is not settled: quadratic drag would remove 9");
    }

    /** Fast enough for a drag that grows with the square of the speed, but who can tell? */
    @ParameterizedTest
    @ValueSource(strings = {"tennis_ball", "volleyball"})
    void theLawsOfTheDragCannotBeToldApart(String ball) throws Exception {
        Diagnosis diagnosis = diagnosis(ball);

        isDrag(diagnosis);
        assertThat(diagnosis.evidence().alternatives())
                .filteredOn(Alternative::isIndistinguishable)
                .extracting(Alternative::causes)
                .contains(List.of("quadratic_drag"));
        assertThat(diagnosis.sentence())
                .contains(
                        "this data cannot tell apart: linear drag is missing, or quadratic drag is"
                                + " missing");
    }

    private static void isDrag(Diagnosis diagnosis) {
        assertThat(diagnosis.runs()).hasSize(2);
        assertThat(diagnosis.verdict()).isEqualTo(Verdict.EXPLAINED);
        assertThat(diagnosis.selected()).extracting(Finding::cause).containsExactly("linear_drag");
        Gain gain = Objects.requireNonNull(diagnosis.prediction().gains().get(Channel.POSITION));
        assertThat(gain.before()).isGreaterThan(0.9);
        assertThat(gain.after()).isLessThan(gain.before() / 5);
    }

    @Test
    void nothingIsMissingForTheGolfBall() throws Exception {
        Diagnosis diagnosis = diagnosis("golf_ball");

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.NONE);
        assertThat(diagnosis.selected()).isEmpty();
        assertThat(diagnosis.evidence().alternatives()).isEmpty();
    }
}
