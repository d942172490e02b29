package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.subject.Cart;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;
import java.util.Set;

/**
 * The way of a cart is told 0.5 s ahead of its commands: of the last five rows nobody knows them.
 */
class BeyondTheEndTest {
    private static final double ACCELERATION = 2;
    private static final double SPACING = 0.1;
    private static final int SAMPLES = 200;
    private static final int AHEAD = 5;
    private static final int HELD = 20;
    private static final Set<String> IDS = Set.of("clock_offset", "impulse", "step_force");

    @Test
    void whatIsToldOfTimesBeyondTheEndIsNoImpulse() throws Exception {
        List<MeasuredRun> runs = List.of(run(1), run(2));
        List<Cause> causes =
                Library.of(Cart.believed(), runs).stream()
                        .filter(c -> IDS.contains(c.id()))
                        .toList();

        Search.Found found =
                new Search(Cart.believed(), runs, causes, Way.THOROUGH, new Course(Progress.SILENT))
                        .found();

        Hypothesis best = found.best().fit().hypothesis();
        assertThat(best.causes()).extracting(Cause::id).containsExactly("clock_offset");
        assertThat(Math.abs(best.numbers()[0])).isCloseTo(AHEAD * SPACING, within(0.002));
    }

    /** At full thrust to and fro; the last turn is one row after the last. */
    private static MeasuredRun run(long seed) {
        Random random = new Random(seed);
        MeasuredRunBuilder run = MeasuredRun.named("run" + seed).commands(List.of("motor"));
        double[] x = new double[SAMPLES + AHEAD + 1];
        double[] v = new double[SAMPLES + AHEAD + 1];
        double[] level = new double[SAMPLES + AHEAD];
        for (int k = 0; k + 1 < x.length; k++) {
            boolean isAnew = k % HELD == 0;
            level[k] = isAnew ? (k / HELD + seed) % 2 == 0 ? 1 : -1 : level[k - 1];
            double gained = ACCELERATION * level[k] * SPACING;
            x[k + 1] = x[k] + SPACING * (v[k] + gained / 2);
            v[k + 1] = v[k] + gained;
        }
        for (int k = 0; k < SAMPLES; k++) {
            double told = x[k + AHEAD] + 0.002 * random.nextGaussian();
            run.at(k * SPACING).measured(Channel.POSITION, told, Double.NaN, Double.NaN);
            run.command(0, level[k]);
        }
        return run.build();
    }
}
