package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Quantity;
import org.auvsim.diagnosis.result.Finding;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;

/** Held-out runs judge what acts in them. */
class UnjudgedMomentTest {
    private static final Finding KICK = finding("impulse", new Quantity("at", "s", 42));
    private static final Finding PUSH = finding("step_force", new Quantity("from", "s", 42));
    private static final Finding DRAG = finding("quadratic_drag", new Quantity("k", "kg/m", 3));

    private static Finding finding(String cause, Quantity number) {
        return new Finding(cause, Optional.empty(), List.of(number), List.of(0.1), 1, true);
    }

    private static MeasuredRun run(double begin) {
        MeasuredRunBuilder run = MeasuredRun.named("run at " + begin);
        for (int k = 0; k < 20; k++) {
            run.at(begin + k).position(k, 0, 0);
        }
        return run.build();
    }

    private static Optional<String> notice(double begin, Finding... found) {
        return UnjudgedMoment.notice(List.of(found), List.of(run(begin)));
    }

    @Test
    void aKickInNoneOfThemIsNotJudged() {
        assertThat(notice(0, KICK)).isPresent();
        assertThat(notice(60, KICK)).isPresent();
        assertThat(notice(30, KICK)).isEmpty();
    }

    @Test
    void whatBeganBeforeThemGoesOn() {
        assertThat(notice(0, PUSH)).isPresent();
        assertThat(notice(60, PUSH)).isEmpty();
    }

    @Test
    void whatElseWasFoundIsJudged() {
        assertThat(notice(0, DRAG)).isEmpty();
        assertThat(notice(0, KICK, DRAG)).isEmpty();
    }
}
