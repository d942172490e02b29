package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.junit.jupiter.api.Test;

import java.util.List;

/** Of a sled whose fan takes 0.2 s to follow, told 0.5 from the first row on. */
class SpinUpTest {
    private static BelievedModel sled(double lag, double level) throws Exception {
        return Believed.model(
                """
                <scenario><time-step delta="0.05"/>
                  <world-object name="sled" mass="2"><sphere radius="0.2"/>
                    <propulsor name="fan" maximum-thrust="3" lag="%s" level="%s"/>
                  </world-object>
                </scenario>
                """
                        .formatted(lag, level),
                "sled");
    }

    private static MeasuredRun run() {
        MeasuredRunBuilder run = MeasuredRun.named("run1").commands(List.of("fan"));
        for (int k = 0; k < 100; k++) {
            double t = 100 + 0.1 * k;
            run.at(t).position(Math.sin(t), Math.cos(t), 0).command(0, 0.5);
        }
        return run.build();
    }

    private static boolean isTold(BelievedModel model, double at) {
        List<MeasuredRun> runs = List.of(run());
        Cause impulse = Library.named(List.of("impulse"), Library.of(model, runs)).getFirst();
        Hypothesis found = Hypothesis.NONE.and(impulse, new double[] {0.3, 0, 0, at});
        return SpinUp.notice(model, runs, found)
                .filter(notice -> notice.startsWith("the impulse is where 'fan' spins up to"))
                .isPresent();
    }

    @Test
    void anImpulseWhileItSpinsUpIsTold() throws Exception {
        assertThat(isTold(sled(0.2, 0), 100.1)).isTrue();
    }

    @Test
    void oneAtAnotherTimeIsNot() throws Exception {
        assertThat(isTold(sled(0.2, 0), 104)).isFalse();
        assertThat(isTold(sled(0.2, 0), 90)).isFalse(); // in a run of another time
    }

    @Test
    void norOneOfAFanThatFollowsAtOnceOrIsRunning() throws Exception {
        assertThat(isTold(sled(0, 0), 100.1)).isFalse();
        assertThat(isTold(sled(0.2, 0.5), 100.1)).isFalse();
    }
}
