package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.FreeSphere;
import org.junit.jupiter.api.Test;

import java.util.List;

/** Positions in steps of half a metre stay off for as long as the body needs for a step. */
class CoarseStepsTest {
    private static final double STEP = 0.5;

    /** On its way nothing acts on it. */
    private static MeasuredRun run(String name, Vec3 velocity) {
        MeasuredRunBuilder run = MeasuredRun.named(name);
        for (int k = 0; k <= 300; k++) {
            Vec3 p = velocity.times(0.1 * k);
            run.at(0.1 * k).position(counted(p.x()), counted(p.y()), counted(p.z()));
        }
        return run.build();
    }

    private static double counted(double number) {
        return STEP * Math.rint(number / STEP);
    }

    @Test
    void areNoFaultOfTheModel() throws Exception {
        BelievedModel model = FreeSphere.believed(0.1);
        List<MeasuredRun> fit =
                List.of(
                        run("run 1", new Vec3(0.83, -0.41, 0.55)),
                        run("run 2", new Vec3(-0.62, 0.77, 0.38)));
        List<MeasuredRun> heldOut = List.of(run("run 3", new Vec3(0.47, 0.58, -0.71)));

        Diagnosis diagnosis =
                new Investigation(model, fit, heldOut, Library.of(model, fit), 1, Progress.SILENT)
                        .diagnose();

        assertThat(diagnosis.verdict()).as(diagnosis.sentence()).isEqualTo(Verdict.NONE);
        assertThat(diagnosis.notices())
                .anyMatch(notice -> notice.contains("told in steps of 0.50 m"))
                .noneMatch(notice -> notice.contains("times the noise"));
    }
}
