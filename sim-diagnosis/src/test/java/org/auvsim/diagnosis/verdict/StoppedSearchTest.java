package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;

/** Whoever stops a search is heard while it follows the runs, too, which may take long. */
class StoppedSearchTest {
    @Test
    void aSearchIsStoppedBeforeItsFirstScreening() throws Exception {
        BelievedModel model = Cart.believed();
        MeasuredRun run = new Cart(1, 4, 0.1).run();
        List<MeasuredRun> runs = List.of(run.part("fit", 0, 199), run.part("held out", 200, 399));
        AtomicInteger asked = new AtomicInteger();
        Progress never =
                (stage, share) -> {
                    asked.incrementAndGet();
                    return false;
                };

        Diagnosis diagnosis =
                new Investigation(
                                model,
                                runs.subList(0, 1),
                                runs.subList(1, 2),
                                Library.of(model, runs),
                                1,
                                never)
                        .diagnose();

        assertThat(diagnosis.isComplete()).isFalse();
        assertThat(diagnosis.selected()).isEmpty();
        assertThat(asked).hasValue(1);
    }

    /** Progress that stops while windows follow a run ends that, not only what comes after it. */
    @Test
    void windowsThatFollowAreStopped() throws Exception {
        MeasuredRun run = new Cart(1, 4, 0.1).run();
        Noise noise = Noise.of(List.of(run));
        AtomicInteger asked = new AtomicInteger();
        Course course = new Course((stage, share) -> asked.incrementAndGet() < 3);

        Stepping stepping = Stepping.longer(Cart.believed()).getFirst();
        List<Misses> data = Misses.of(List.of(run), noise);
        Fit stopped = Following.of(stepping, Hypothesis.NONE, data, noise, course);

        assertThat(stopped.windows().getFirst().getLast().to()).isEqualTo(run.size() - 1);
        assertThat(asked).hasValue(3);
    }
}
