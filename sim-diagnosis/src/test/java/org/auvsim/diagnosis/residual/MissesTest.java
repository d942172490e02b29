package org.auvsim.diagnosis.residual;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.model.Sensing;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

/** A body that is held at x = 0 m and then let go at 2 m/s, told late by a few rows. */
class MissesTest {
    private static final int ROWS = 40;
    private static final double SPACING = 0.1;
    private static final double SPEED = 2;
    private static final double NOISE = 0.01;
    private static final Sensing LATE = Sensing.EXACT.delayed(0.35);

    /** Rows whose time, less the delay, is before the first. */
    private static final int BEFORE = 4;

    private static Misses misses() {
        Random random = new Random(1);
        MeasuredRunBuilder run = MeasuredRun.named("run");
        for (int k = 0; k < ROWS; k++) {
            double x = SPEED * Math.max(0, k * SPACING - 0.35) + NOISE * random.nextGaussian();
            run.at(k * SPACING).position(x, Double.NaN, Double.NaN);
        }
        List<MeasuredRun> runs = List.of(run.build());
        return Misses.of(runs, Noise.of(runs)).getFirst();
    }

    private static double[] missed(Misses of, Sensing sensing) {
        RigidMotion[] motions =
                IntStream.range(0, ROWS)
                        .mapToObj(
                                k ->
                                        new RigidMotion(
                                                new Vec3(SPEED * k * SPACING, 0, 0),
                                                Quat.IDENTITY,
                                                new Vec3(SPEED, 0, 0),
                                                Vec3.ZERO))
                        .toArray(RigidMotion[]::new);
        return of.of(motions, sensing, 0, ROWS);
    }

    private static Misses seen(Misses of, Sensing sensing) {
        return of.seen(sensing, missed(of.allSeen(), sensing));
    }

    @Test
    void whatIsToldOfTimesBeforeTheFirstRowCountsAsNoise() {
        Misses all = misses();
        Misses seen = seen(all, LATE);

        assertThat(Math.abs(missed(all, LATE)[0])).isGreaterThan(10);
        assertThat(missed(seen, LATE)).startsWith(1, -1, 1, -1);
        assertThat(missed(seen, LATE)[BEFORE]).isEqualTo(missed(all, LATE)[BEFORE]);
        assertThat(seen.isMeasured(0)).isTrue();
        assertThat(seen.counts(0)).isFalse();
        assertThat(seen.uncounted()).hasSize(all.uncounted().size() + BEFORE);
        assertThat(missed(seen.allSeen(), LATE)).isEqualTo(missed(all, LATE));
    }

    /** Where the body goes on as it did, they tell how late they are. */
    @Test
    void whatMissesNoMoreThanNoiseCounts() {
        Misses all = misses();

        assertThat(seen(all, Sensing.EXACT)).isSameAs(all);
        assertThat(all.seen(LATE, new double[ROWS])).isSameAs(all);
    }

    /** Or else a sensor that is late by most of a run would explain whatever is in it. */
    @Test
    void mostOfARunMustBeSeen() {
        Misses all = misses();

        assertThat(seen(all, Sensing.EXACT.delayed(1.5))).isSameAs(all);
    }

    @Test
    void whatComesAfterTheLastRowIsNotSeenEither() {
        Misses all = misses();
        Misses seen = seen(all, Sensing.EXACT.delayed(-0.25));

        assertThat(seen.counts(ROWS - 1)).isFalse();
        assertThat(seen.counts(ROWS - 4)).isTrue();
    }
}
