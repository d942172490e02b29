package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Descent;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.Alternative;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.search.Tournament;
import org.auvsim.diagnosis.search.Tried;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.subject.MeasuredTorpedo;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Set;

/**
 * A torpedo that begins at rest and is steered by a rudder, its position noisy: a few samples tell
 * its velocity so badly that windows which begin by them lead astray, as its heading is unstable.
 */
@Tag("whole-search")
class NoisyTorpedoTest {
    private List<MeasuredRun> runs;
    private Noise noise;

    @BeforeEach
    void itIsMeasured() throws Exception {
        runs = runs(Vec3.ZERO);
        noise = Noise.of(runs);
    }

    @Test
    void itsModelFollowsItAllTheWay() throws Exception {
        Fit fit = followed(MeasuredTorpedo.model(MeasuredTorpedo.WORN), Hypothesis.NONE);

        assertThat(fit.windows()).allSatisfy(windows -> assertThat(windows).hasSize(1));
        assertThat(Judged.of(fit).isWhite()).isTrue();
    }

    /** Windows that follow the run without what is missing begin where no model fits all of it. */
    @Test
    void onceTheCauseIsFoundTheRunsBeginAnew() throws Exception {
        BelievedModel model = MeasuredTorpedo.model(MeasuredTorpedo.RUDDER);
        Cause gain =
                Library.of(model, runs).stream()
                        .filter(cause -> cause.id().equals("fin_gain"))
                        .findFirst()
                        .orElseThrow();
        Fit astray = followed(model, Hypothesis.NONE);
        Hypothesis found = Hypothesis.NONE.and(gain, new double[] {-0.25});
        Judged stuck =
                Descent.of(astray.with(found, astray.windows()).whole())
                        .steps(Tournament.TO_THE_END);
        Tried tried = new Tried(Judged.of(astray.whole()), noise, Course.UNHEARD);

        Judged anew = tried.begunAnew(stuck);

        assertThat(stuck.isWhite()).isFalse();
        assertThat(anew.isWhite()).isTrue();
        assertThat(tried.eachSetOnce()).contains(anew);
    }

    /** By Galileo both are the same; fits from starts of their own ended apart. */
    @Test
    void waterThatFlowsIsNotToldFromAPositionThatDrifts() throws Exception {
        BelievedModel model = MeasuredTorpedo.model(MeasuredTorpedo.WORN);
        List<MeasuredRun> flowing = runs(new Vec3(0.1, 0.3, 0));
        List<Cause> causes =
                Library.of(model, flowing).stream()
                        .filter(c -> Set.of("current_constant", "position_drift").contains(c.id()))
                        .toList();

        Diagnosis diagnosis =
                new Investigation(
                                model,
                                flowing.subList(0, 2),
                                flowing.subList(2, 3),
                                causes,
                                1,
                                Progress.SILENT)
                        .diagnose();

        assertThat(diagnosis.selected())
                .extracting(Finding::cause)
                .containsExactly("current_constant");
        assertThat(diagnosis.evidence().alternatives())
                .filteredOn(Alternative::isIndistinguishable)
                .extracting(Alternative::causes)
                .containsExactly(List.of("position_drift"));
        assertThat(diagnosis.evidence().nextExperiment()).isEmpty(); // it would tell no more
    }

    private Fit followed(BelievedModel model, Hypothesis hypothesis) {
        return Following.of(Stepping.exact(model), hypothesis, Misses.of(runs, noise), noise);
    }

    private static List<MeasuredRun> runs(Vec3 flow) throws Exception {
        BelievedModel worn = MeasuredTorpedo.model(MeasuredTorpedo.WORN);
        return List.of(
                MeasuredTorpedo.run(worn, 1, 0.3, flow),
                MeasuredTorpedo.run(worn, 2, -2.2, flow),
                MeasuredTorpedo.run(worn, 3, 1.9, flow));
    }
}
