package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.subject.Surveyor;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/** A model that is wrong in four ways at once, no two of which explain anything like the runs. */
@Tag("whole-search")
class SeveralCausesTest {
    private static final Surveyor SURVEYOR =
            new Surveyor(12.4, new Vec3(0.12, -0.08, 0), 0.85, 1.5);

    private static double number(Hypothesis of, String label) {
        for (int c = 0; c < of.causes().size(); c++) {
            if (of.causes().get(c).label().equals(label)) {
                return of.theta().get(c)[0];
            }
        }
        throw new AssertionError(label + " is not among " + of.causes());
    }

    private static Search.Found found(Way way) throws Exception {
        BelievedModel model = Surveyor.believed();
        Random random = new Random(3);
        List<MeasuredRun> runs =
                List.of(SURVEYOR.run("run 1", random), SURVEYOR.run("run 2", random));
        List<Cause> common =
                Library.of(model, runs).stream()
                        .filter(cause -> !cause.isGeneric())
                        .filter(cause -> cause.guesses(runs).size() <= 2)
                        .toList();
        return new Search(model, runs, common, way, new Course(Progress.SILENT)).found();
    }

    @Test
    void allOfThemAreFound() throws Exception {
        Search.Found found = found(Way.THOROUGH);

        Hypothesis best = found.best().fit().hypothesis();
        assertThat(found.best().isWhite()).isTrue();
        assertThat(best.causes())
                .extracting(Cause::label)
                .containsExactlyInAnyOrder(
                        "quadratic_drag",
                        "current_constant",
                        "thruster_gain (port)",
                        "rotational_drag");
        assertThat(number(best, "quadratic_drag")).isCloseTo(12.4, within(0.1));
        assertThat(number(best, "current_constant")).isCloseTo(0.12, within(0.002));
        assertThat(number(best, "thruster_gain (port)")).isCloseTo(-0.15, within(0.001));
        assertThat(number(best, "rotational_drag")).isCloseTo(1.5, within(0.01));
    }

    /** Of data that reading doubts more causes would be doubted, too, and take their time. */
    @Test
    void noMoreThanTwoAreLookedForInAHurry() throws Exception {
        Search.Found found = found(Way.THOROUGH.cursory());

        assertThat(found.best().isWhite()).isFalse();
        assertThat(found.judged())
                .isNotEmpty()
                .allSatisfy(
                        set -> assertThat(set.fit().hypothesis().causes().size()).isLessThan(3));
    }
}
