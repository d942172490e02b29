package org.auvsim.diagnosis.cause;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.model.Ensemble;
import org.auvsim.diagnosis.model.Variant;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;

/** What swings in a run that begins at ten o'clock swings as in one that begins at 0 s. */
class LateClockTest {
    private static final double TEN_O_CLOCK = 36_000;
    private static final int SAMPLES = 60;
    private static final BelievedModel MODEL = Tank.vehicle();

    private static MeasuredRun run(double begin) {
        MeasuredRun of = Tank.run(MODEL, SAMPLES);
        MeasuredRunBuilder run = MeasuredRun.named("run");
        for (int k = 0; k < SAMPLES; k++) {
            run.at(begin + k * Tank.SPACING)
                    .position(
                            of.value(Channel.POSITION, k, 0),
                            of.value(Channel.POSITION, k, 1),
                            of.value(Channel.POSITION, k, 2));
        }
        return run.build();
    }

    private static RigidMotion[] motion(String id, MeasuredRun run, double[] theta) {
        Cause cause = Library.named(List.of(id), Library.of(MODEL, List.of(run))).getFirst();
        Variant swinging = cause.in(MODEL.variant(), theta);
        return Ensemble.simulate(
                MODEL, run, 0, SAMPLES - 1, List.of(new Ensemble.Entrant(swinging, Tank.START)))[0];
    }

    private static double[] theta(String id) {
        return id.equals("wave_forcing")
                ? new double[] {3, 2, 0.4, 1.7, 1}
                : new double[] {0.3, 0.1, 0, 0.2, 0, 0.1, 1.7};
    }

    @ParameterizedTest
    @ValueSource(strings = {"periodic_force", "current_oscillating", "wave_forcing"})
    void swingsCountFromWhereRunsBegin(String id) {
        RigidMotion[] early = motion(id, run(0), theta(id));
        RigidMotion[] late = motion(id, run(TEN_O_CLOCK), theta(id));

        assertThat(late[SAMPLES - 1].position().distance(early[SAMPLES - 1].position()))
                .isCloseTo(0, within(1e-7));
    }

    /** A wrong frequency is wrong for as long as a run lasts, and not since midnight. */
    @ParameterizedTest
    @ValueSource(strings = {"periodic_force", "current_oscillating", "wave_forcing"})
    void aSmallChangeOfTheFrequencyIsASmallChangeOfTheMotion(String id) {
        double[] other = theta(id);
        int omega = id.equals("wave_forcing") ? 3 : 6;
        other[omega] += 1e-3;
        RigidMotion[] motion = motion(id, run(TEN_O_CLOCK), theta(id));
        RigidMotion[] changed = motion(id, run(TEN_O_CLOCK), other);

        assertThat(changed[SAMPLES - 1].position().distance(motion[SAMPLES - 1].position()))
                .isBetween(1e-9, 2e-3);
    }
}
