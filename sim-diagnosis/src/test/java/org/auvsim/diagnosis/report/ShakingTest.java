package org.auvsim.diagnosis.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Ranked;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.shaking.Imbalance;
import org.auvsim.diagnosis.shaking.Shaking;
import org.auvsim.plot.page.ReportPage;
import org.junit.jupiter.api.Test;

import java.util.List;

/** What a diagnosis says of shaking beside the motion. */
class ShakingTest {
    private static final Shaking MUCH = new Shaking(3.12, 0.48, 2.6, 4, 8, 1);
    private static final Shaking NORMAL = new Shaking(1.1, 0.48, 2.6, 0.2, 8, 1);

    private static final String SENTENCE =
            "The vehicle shakes 3.1 +- 0.5 times as much as in the 8 reference runs, and moves as"
                    + " the model has it: a propeller is out of balance, or damaged";

    @Test
    void whereTheMotionLacksNothingItIsAPropeller() {
        Diagnosis diagnosis = Imbalance.judged(Diagnoses.none(), MUCH);

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.EXPLAINED);
        assertThat(diagnosis.sentence()).isEqualTo(SENTENCE);
        assertThat(diagnosis.selected())
                .extracting(Finding::name)
                .containsExactly("propeller_imbalance");
        assertThat(diagnosis.evidence().candidates())
                .isEqualTo(Diagnoses.none().evidence().candidates() + 1);
        assertThat(diagnosis.notices()).isEqualTo(Diagnoses.none().notices());
        assertThat(diagnosis.extended()).isEqualTo(Diagnoses.none().extended());
    }

    /** By Schwarz's criterion: half of 9 ln(1 + 4^2 / 7), less half of ln 9. */
    @Test
    void itsEvidenceIsThatOfAnotherMean() {
        List<Ranked> ranked = Imbalance.judged(Diagnoses.none(), MUCH).evidence().ranked();

        assertThat(ranked.getFirst().causes()).containsExactly("propeller_imbalance");
        assertThat(
                        ranked.getFirst().logEvidence()
                                - Diagnoses.none().evidence().ranked().getFirst().logEvidence())
                .isCloseTo(4.5 * Math.log(1 + 16 / 7.0) - Math.log(9) / 2, within(1e-9));
        assertThat(ranked.stream().mapToDouble(Ranked::probability).sum())
                .isCloseTo(1, within(1e-9));
    }

    @Test
    void whereSomethingElseIsFoundThatMayShakeIt() {
        Diagnosis found = Imbalance.judged(Diagnoses.explained(), MUCH);
        Diagnosis open = Imbalance.judged(Diagnoses.unexplained(), MUCH);

        assertThat(found.sentence()).isEqualTo(Diagnoses.explained().sentence());
        assertThat(found.notices())
                .contains(
                        "the vehicle shakes 3.1 +- 0.5 times as much as in the 8 reference runs (of"
                            + " sound ones 1 in 100 exceeds 2.6); what was found may shake it, or a"
                            + " propeller that is out of balance, too");
        assertThat(open.verdict()).isEqualTo(Verdict.UNEXPLAINED);
        assertThat(open.notices()).anyMatch(notice -> notice.contains("what is not explained may"));
    }

    @Test
    void normalShakingIsToldAsThat() {
        Diagnosis diagnosis = Imbalance.judged(Diagnoses.none(), NORMAL);

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.NONE);
        assertThat(diagnosis.notices())
                .contains(
                        "the vehicle shakes 1.1 +- 0.5 times as much as in the 8 reference runs,"
                                + " which is normal: of sound ones 1 in 100 exceeds 2.6");
    }

    @Test
    void pageAndScenarioSayIt() {
        Diagnosis diagnosis = Imbalance.judged(Diagnoses.none(), MUCH);

        assertThat(ReportPage.html(Page.of(diagnosis)))
                .contains("propeller_imbalance")
                .contains("a propeller is out of balance, or damaged");
        assertThat(ExtendedScenario.text(diagnosis))
                .contains(SENTENCE)
                .contains("Nothing was added: this is the model as it was believed.");
    }
}
