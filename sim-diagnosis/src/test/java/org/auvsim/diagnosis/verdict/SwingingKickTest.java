package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.Investigation;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.result.Diagnosis;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.result.Verdict;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Believed;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/**
 * A cart between two springs that is kicked once in one of its runs, which are at different times
 * of one clock. A kick at another moment, half a swing away, is nearly the same the other way
 * round.
 */
class SwingingKickTest {
    private static final double MASS = 5;
    private static final double STIFFNESS = 16;
    private static final double DAMPING = 0.8;
    private static final double KICK = 1;
    private static final double AT = 45.3;
    private static final double NOISE = 0.01;

    private static final double DECAY = DAMPING / (2 * MASS);
    private static final double FREQUENCY = Math.sqrt(STIFFNESS / MASS - DECAY * DECAY);

    private static BelievedModel believed() throws Exception {
        return Believed.model(
                """
                <scenario><time-step delta="0.02"/>
                  <world-object name="cart" mass="5"><box><size x="0.4" y="0.4" z="0.2"/></box>
                    <held y="1" z="1" turn-x="1" turn-y="1" turn-z="1"/>
                    <damping><linear x="0.8" y="0" z="0"/><quadratic x="0" y="0" z="0"/>
                      <angular-linear x="0" y="0" z="0"/><angular-quadratic x="0" y="0" z="0"/></damping>
                    <mooring length="1" stiffness="8" damping="0"><anchor x="3" y="0" z="0"/></mooring>
                    <mooring length="1" stiffness="8" damping="0"><anchor x="-3" y="0" z="0"/></mooring>
                  </world-object>
                </scenario>
                """,
                "cart");
    }

    /** The damped swing of a start, and that of the kick from its moment on. */
    private static MeasuredRun run(double begin, double from) {
        Random random = new Random((long) begin);
        MeasuredRunBuilder run = MeasuredRun.named("run at " + begin);
        for (int k = 0; k <= 300; k++) {
            double t = 0.1 * k;
            double began =
                    from
                            * Math.exp(-DECAY * t)
                            * (Math.cos(FREQUENCY * t)
                                    + DECAY / FREQUENCY * Math.sin(FREQUENCY * t));
            double since = begin + t - AT;
            boolean isLater = 0 < since && begin < AT;
            double kicked =
                    isLater
                            ? KICK
                                    / (MASS * FREQUENCY)
                                    * Math.exp(-DECAY * since)
                                    * Math.sin(FREQUENCY * since)
                            : 0;
            double x = began + kicked + NOISE * random.nextGaussian();
            run.at(begin + t).measured(Channel.POSITION, x, Double.NaN, Double.NaN);
        }
        return run.build();
    }

    @Test
    void isFoundAtItsMomentThoughNoOtherRunIsOfThatTime() throws Exception {
        BelievedModel model = believed();
        List<MeasuredRun> fit = List.of(run(0, 0.5), run(35, -0.4), run(70, 0.3));
        List<String> some =
                List.of("impulse", "step_force", "wave_forcing", "quadratic_drag", "sensor_delay");

        Diagnosis diagnosis =
                new Investigation(
                                model,
                                fit,
                                List.of(run(105, 0.4), run(140, -0.5)),
                                Library.named(some, Library.of(model, fit)),
                                1,
                                Progress.SILENT)
                        .diagnose();

        assertThat(diagnosis.verdict()).as(diagnosis.sentence()).isEqualTo(Verdict.EXPLAINED);
        assertThat(diagnosis.selected()).extracting(Finding::cause).containsExactly("impulse");
        assertThat(diagnosis.notices())
                .singleElement()
                .asString()
                .startsWith("what was found acts at a time at which there is no held-out run");
        Finding kick = diagnosis.selected().getFirst();
        assertThat(kick.quantities().getFirst().value()).isCloseTo(KICK, within(0.1));
        assertThat(kick.quantities().getLast().value()).isCloseTo(AT, within(0.1));
    }
}
