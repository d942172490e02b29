package org.auvsim.diagnosis.genetic;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.PushedSphere;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Proposal;
import org.auvsim.diagnosis.result.Verdict;
import org.junit.jupiter.api.Test;

import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;

/** Where no cause explains what is measured, a formula is proposed, and named nowhere. */
class ProposalTest {
    /** A drag along x that grows with the distance from the plane y = 0: no library has it. */
    private static final PushedSphere SPHERE =
            new PushedSphere((p, v) -> new double[] {-6 * Math.abs(p[1]) * v[0], 0, 0});

    private static final Set<String> CAUSES =
            Set.of("linear_drag", "quadratic_drag", "current_constant");

    @Test
    void aForceThatNoCauseHasIsImitatedByAFormula() {
        Diagnosis diagnosis = SPHERE.investigation(1, CAUSES).diagnose();

        assertThat(diagnosis.verdict()).as(diagnosis.sentence()).isEqualTo(Verdict.UNEXPLAINED);
        assertThat(diagnosis.selected()).isEmpty();
        assertThat(diagnosis.conclusion().proposal()).isPresent();
        Proposal proposal = diagnosis.conclusion().proposal().orElseThrow();
        assertThat(proposal.kind()).isEqualTo("formula");
        assertThat(proposal.text()).contains("F.x =").contains("vx").doesNotContain("F.z");
        assertThat(proposal.heldOut().after())
                .as(proposal.text())
                .isLessThan(proposal.heldOut().before() / 3);
    }

    /** The search is over by then: what it says stays. */
    @Test
    void whoeverStopsItThenHasTheDiagnosisWithoutOne() {
        AtomicInteger asked = new AtomicInteger();
        Progress until =
                (stage, share) ->
                        !stage.equals("looking for a formula or a field")
                                || asked.incrementAndGet() < 5;
        Investigation of = SPHERE.investigation(1, CAUSES);

        Diagnosis diagnosis =
                new Investigation(of.model(), of.fit(), of.heldOut(), of.causes(), 1, until)
                        .diagnose();

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.UNEXPLAINED);
        assertThat(diagnosis.isComplete()).isTrue();
        assertThat(diagnosis.conclusion().proposal()).isEmpty();
        assertThat(asked).hasValue(5);
    }
}
