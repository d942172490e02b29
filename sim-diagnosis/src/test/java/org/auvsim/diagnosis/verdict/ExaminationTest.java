package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.result.Gain;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

import java.util.List;

class ExaminationTest {
    private static final MeasuredRun WHOLE = new Cart(0.8, 1e-5, 0).run();
    private static final MeasuredRun FIRST = WHOLE.part("first", 0, 200);
    private static final MeasuredRun SECOND = WHOLE.part("second", 200, 399);

    @Test
    void runsAreSearchedTogetherThatAreToBePredictedAsFarAhead() {
        assertThat(areAsLong(List.of(WHOLE), List.of(WHOLE))).isTrue();
        assertThat(areAsLong(List.of(FIRST), List.of(SECOND))).isTrue();
    }

    @Test
    void partsAreNotSearchedTogetherWithWholeRuns() {
        assertThat(areAsLong(List.of(FIRST, SECOND), List.of(WHOLE))).isFalse();
        assertThat(areAsLong(List.of(FIRST), List.of(SECOND, WHOLE))).isFalse();
    }

    /** Ends that were cut off make a part of a run, too. */
    @Test
    void howLongTheyAreDecides() {
        MeasuredRun most = WHOLE.part("most", 0, 300);

        assertThat(areAsLong(List.of(most), List.of(WHOLE))).isTrue();
        assertThat(areAsLong(List.of(WHOLE.part("piece", 0, 40)), List.of(most))).isFalse();
    }

    /** It was taken to leave something out, not to predict less far ahead. */
    @Test
    void aStretchOfARunIsNoPart() {
        MeasuredRun early = WHOLE.stretch(10, 100);

        assertThat(areAsLong(List.of(early), List.of(WHOLE))).isTrue();
        assertThat(areAsLong(List.of(early.part("piece", 0, 40)), List.of(WHOLE))).isFalse();
    }

    /** An orientation that was told rightly before cannot be told twice as well. */
    @Test
    void whatIsMuchNearerSomewhereAndFartherNowhereIsNearer() {
        Gain much = new Gain(7.8, 0.01, 0.0099);
        Gain none = new Gain(0.005, 0.0051, 0.0045);
        Gain worse = new Gain(0.005, 0.02, 0.0045);

        assertThat(Examination.isNearer(List.of(much, none))).isTrue();
        assertThat(Examination.isNearer(List.of(none))).isFalse();
        assertThat(Examination.isNearer(List.of(much, worse))).isFalse();
        assertThat(Examination.isNearer(List.of())).isFalse();
    }

    private static boolean areAsLong(List<MeasuredRun> fit, List<MeasuredRun> heldOut) {
        return Examination.areAsLong(fit, heldOut);
    }
}
