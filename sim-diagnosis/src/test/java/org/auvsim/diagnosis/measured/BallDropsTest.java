package org.auvsim.diagnosis.measured;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;
import org.junit.jupiter.api.Tag;
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
                "tennis_ball",
                "volleyball",
                "whiffle_ball_1",
                "whiffle_ball_2",
                "orange_whiffle_ball",
                "yellow_whiffle_ball"
            })
    void aLightBallDoesNotFallFreely(String ball) throws Exception {
        Diagnosis diagnosis = diagnosis(ball);

        assertThat(diagnosis.runs()).hasSize(2);
        assertThat(diagnosis.verdict()).isNotEqualTo(Verdict.NONE);
        Gain gain = Objects.requireNonNull(diagnosis.heldOut().get(Channel.POSITION));
        assertThat(gain.before()).isBetween(0.9, 3.8);
        assertThat(gain.after()).isLessThan(0.7);
    }
}
