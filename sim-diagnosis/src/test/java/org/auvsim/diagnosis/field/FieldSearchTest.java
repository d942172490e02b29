package org.auvsim.diagnosis.field;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.PushedSphere;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.result.DiagnosedRun;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.ForceResidual;
import org.auvsim.diagnosis.result.Proposal;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.search.Way;
import org.auvsim.diagnosis.verdict.Examination;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;

/** What a place does is mapped, and what time does is not. */
@Tag("whole-search")
class FieldSearchTest {
    private static final Set<String> CAUSES = Set.of("linear_drag", "current_constant");

    /** A bowl with an egg box in it: the slope of 4 r^2 - 5 cos 1.5 x cos 1.5 y. */
    private static double[] eggBox(double[] p) {
        double x = 1.5 * p[0];
        double y = 1.5 * p[1];
        return new double[] {
            -8 * p[0] - 7.5 * Math.sin(x) * Math.cos(y),
            -8 * p[1] - 7.5 * Math.cos(x) * Math.sin(y),
            -8 * p[2]
        };
    }

    /** What runs say, with a field if there is one. */
    private static Diagnosis mapped(PushedSphere sphere) {
        Investigation of = sphere.investigation(1, CAUSES);
        return new Examination(
                        of.model(),
                        of.fit(),
                        of.heldOut(),
                        of.causes(),
                        1,
                        Way.THOROUGH,
                        Progress.SILENT)
                .diagnosis(List.of(new FieldSearch()));
    }

    @Test
    void aForceThatDependsOnThePlaceIsMapped() {
        Diagnosis diagnosis = mapped(new PushedSphere((p, v) -> eggBox(p)));

        Proposal proposal = diagnosis.conclusion().proposal().orElseThrow();

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.UNEXPLAINED);
        assertThat(diagnosis.selected()).isEmpty();
        assertThat(proposal.kind()).isEqualTo("force_field");
        assertThat(proposal.text()).contains("potentials of a width of").contains(" N at most");
        assertThat(proposal.heldOut().after()).isLessThan(proposal.heldOut().before() / 2);
    }

    @Test
    @Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void aBodyThatStaysWhereItIsHasNoField() {
        MeasuredRunBuilder still = MeasuredRun.named("still");
        List<ForceResidual> forces = new ArrayList<>();
        for (int k = 0; k < 20; k++) {
            still.at(k).position(3, -2, 1);
            forces.add(new ForceResidual(k, new Vec3(1, 0, k % 2), Vec3.ZERO));
        }

        DiagnosedRun run =
                new DiagnosedRun(still.build(), false, List.of(), List.of(), forces, Set.of());

        assertThat(FieldSearch.field(List.of(run), () -> true)).isEmpty();
    }

    @Test
    void kicksAreNoField() {
        SplittableRandom lot = new SplittableRandom(7);
        double[] kick = new double[3];
        int[] calls = {0};
        PushedSphere kicked =
                new PushedSphere(
                        (p, v) -> {
                            for (int i = 0; i < 3 && calls[0] % 3000 == 0; i++) {
                                kick[i] = 10 * lot.nextGaussian();
                            }
                            calls[0]++;
                            return kick;
                        });
        Diagnosis diagnosis = mapped(kicked);

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.UNEXPLAINED);
        assertThat(diagnosis.conclusion().proposal()).isEmpty();
    }
}
