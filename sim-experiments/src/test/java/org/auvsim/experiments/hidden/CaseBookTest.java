package org.auvsim.experiments.hidden;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class CaseBookTest {
    @ParameterizedTest
    @EnumSource(CaseKind.class)
    void aCaseHidesWhatItsKindSays(CaseKind kind) {
        HiddenCase of = CaseBook.draw(kind, 0.01, 3);

        assertThat(of.hidden())
                .hasSize(kind == CaseKind.NULL ? 0 : kind == CaseKind.PAIR ? 2 : 1)
                .allMatch(
                        e ->
                                kind == CaseKind.ALIAS
                                        || Effects.LIBRARY.containsKey(e.cause())
                                                != (kind == CaseKind.UNCOVERED));
        assertThat(of.fit()).hasSize(3);
        assertThat(of.heldOut()).hasSize(2);
        assertThat(of.twins().isPresent()).isEqualTo(kind == CaseKind.ALIAS);
        assertThat(of.model().variant().body().mass()).isPresent();
    }

    @Test
    void theSameSeedIsTheSameCaseAndNoiseIsAllThatNoiseChanges() {
        HiddenCase first = CaseBook.draw(CaseKind.SINGLE, 0.01, 5);
        HiddenCase again = CaseBook.draw(CaseKind.SINGLE, 0.01, 5);
        HiddenCase louder = CaseBook.draw(CaseKind.SINGLE, 0.05, 5);

        assertThat(x(again)).isEqualTo(x(first)).isNotEqualTo(x(louder));
        assertThat(again.hidden().toString())
                .isEqualTo(first.hidden().toString())
                .isEqualTo(louder.hidden().toString());
        assertThat(louder.truth()).isEqualTo(first.truth());
    }

    private static double[] x(HiddenCase of) {
        MeasuredRun run = of.fit().getFirst();
        double[] x = new double[run.size()];
        for (int k = 0; k < x.length; k++) {
            x[k] = run.value(Channel.POSITION, k, 0);
        }
        return x;
    }
}
