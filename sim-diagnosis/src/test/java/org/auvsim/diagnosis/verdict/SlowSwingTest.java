package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.junit.jupiter.api.Test;

import java.util.List;

/** Of a sled that was measured for 10 s. */
class SlowSwingTest {
    private static MeasuredRun run(double from) {
        MeasuredRunBuilder run = MeasuredRun.named("run1");
        for (int k = 0; k <= 100; k++) {
            double t = from + 0.1 * k;
            run.at(t).position(Math.sin(t), Math.cos(t), 0);
        }
        return run.build();
    }

    private static List<String> notices(List<MeasuredRun> runs, double omega) throws Exception {
        BelievedModel model =
                Believed.model(
                        """
                        <scenario><time-step delta="0.05"/>
                          <world-object name="sled" mass="2"><sphere radius="0.2"/></world-object>
                        </scenario>
                        """,
                        "sled");
        Cause force = Library.named(List.of("periodic_force"), Library.of(model, runs)).getFirst();
        double[] theta =
                force.guesses(runs).getFirst().theta().stream()
                        .mapToDouble(Double::doubleValue)
                        .toArray();
        int at = force.parameters().stream().map(Parameter::name).toList().indexOf("omega");
        theta[at] = omega;
        return SlowSwing.notices(runs, Hypothesis.NONE.and(force, theta));
    }

    @Test
    void aSwingOfWhichRunsShowOnlyAPartIsTold() throws Exception {
        assertThat(notices(List.of(run(0), run(0)), 0.3))
                .singleElement()
                .asString()
                .startsWith("the period of periodic_force, 21 s, is longer than the 10 s that");
    }

    @Test
    void oneThatTheyShowWholeIsNot() throws Exception {
        assertThat(notices(List.of(run(0)), 0.7)).isEmpty();
        assertThat(notices(List.of(run(0), run(20)), 0.3)).isEmpty(); // at two of its times
    }
}
