package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.search.RunByRun;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.subject.Believed;
import org.auvsim.diagnosis.subject.Surveyor;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;
import java.util.stream.Stream;

/** A vehicle that fouls between its runs has no drag that explains all of them. */
@Tag("whole-search")
class RunByRunTest {
    private static MeasuredRun run(int seed, double quadratic, double turning) {
        return new Surveyor(quadratic, Vec3.ZERO, 1, turning).run("run" + seed, new Random(seed));
    }

    private static Diagnosis diagnosis(MeasuredRun... runs) throws Exception {
        BelievedModel model = Surveyor.believed();
        List<MeasuredRun> fit = List.of(runs[0], runs[1]);
        List<String> some =
                List.of("linear_drag", "quadratic_drag", "thruster_gain", "sensor_delay");
        return Believed.suspectedOf(some, model, fit, List.of(runs[2]));
    }

    @Test
    void whatChangedBetweenRunsIsTold() throws Exception {
        Diagnosis diagnosis = diagnosis(run(1, 0, 0), run(2, 12, 0), run(3, 12, 0));

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.UNEXPLAINED);
        assertThat(diagnosis.notices())
                .filteredOn(notice -> notice.startsWith("each run by itself"))
                .singleElement()
                .asString()
                .containsPattern(
                        "^each run by itself is explained by quadratic_drag, but not by the same:"
                                + " k \\(kg/m\\) is -?0\\.0\\d* \\+- 0\\.0\\d+ in run1,"
                                + " 1[12]\\.\\d+ \\+- 0\\.0\\d+ in run2, 1[12]\\.\\d+"
                                + " \\+- 0\\.0\\d+ in run3; something changed");
    }

    /** Two causes of one number each as one of two. */
    private record Both(Cause one, Cause other) implements Cause {
        @Override
        public String id() {
            return "both";
        }

        @Override
        public List<Parameter> parameters() {
            return List.of(one.parameters().getFirst(), other.parameters().getFirst());
        }

        @Override
        public Variant in(Variant model, double[] theta) {
            return other.in(one.in(model, new double[] {theta[0]}), new double[] {theta[1]});
        }
    }

    @Test
    void ofSeveralCausesTheOneOfFewestNumbersIsTold() throws Exception {
        BelievedModel model = Surveyor.believed();
        List<MeasuredRun> runs = List.of(run(1, 0, 0), run(2, 12, 0), run(3, 12, 0));
        Noise noise = Noise.of(runs);
        List<Cause> library = Library.of(model, runs);
        Cause quadratic = cause(library, "quadratic_drag");
        List<Hypothesis> causes =
                Stream.of(new Both(quadratic, cause(library, "linear_drag")), quadratic)
                        .map(c -> Hypothesis.NONE.and(c, new double[c.parameters().size()]))
                        .toList();
        RunByRun byRun =
                new RunByRun(
                        Stepping.exact(model),
                        Misses.of(runs, noise),
                        noise,
                        new Course(Progress.SILENT));

        assertThat(byRun.notice(causes)).get().asString().contains("by quadratic_drag");
        assertThat(byRun.notice(causes.subList(0, 1))).get().asString().contains("by both");
    }

    private static Cause cause(List<Cause> library, String id) {
        return library.stream().filter(c -> c.id().equals(id)).findFirst().orElseThrow();
    }

    @Test
    void whatNoneOfTheseExplainsIsNot() throws Exception {
        Diagnosis diagnosis = diagnosis(run(1, 0, 1.5), run(2, 0, 1.5), run(3, 0, 1.5));

        assertThat(diagnosis.verdict()).isEqualTo(Verdict.UNEXPLAINED);
        assertThat(diagnosis.notices())
                .noneMatch(notice -> notice.startsWith("each run by itself"));
    }
}
