package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.shooting.Window;
import org.auvsim.diagnosis.subject.FreeSphere;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Random;

/** Of a body that goes at 1 m/s, and by whose turns nothing is known. */
class OrdinaryWindowsTest {
    private static MeasuredRun run() {
        MeasuredRunBuilder run = MeasuredRun.named("coasting");
        Random random = new Random(3);
        for (int k = 0; k < 200; k++) {
            double t = 0.1 * k;
            run.at(t).position(t + 0.01 * random.nextGaussian(), 0, 0);
        }
        return run.build();
    }

    private static Window window(int from, double speed) {
        RigidMotion start =
                new RigidMotion(
                        new Vec3(0.1 * from, 0, 0),
                        Quat.IDENTITY,
                        new Vec3(0, speed, 0),
                        Vec3.ZERO);
        return new Window(from, from + 50, start);
    }

    private static List<Window> ordinary(List<Window> windows) throws Exception {
        List<MeasuredRun> runs = List.of(run());
        Noise noise = Noise.of(runs);
        Stepping stepping = Stepping.exact(FreeSphere.believed(0.1));
        List<Misses> data = Misses.of(runs, noise);
        Fit fit = new Fit(stepping, data, Hypothesis.NONE, List.of(windows), Knowledge.NONE);
        return OrdinaryWindows.of(fit, noise).windows().getFirst();
    }

    @Test
    void whatBeginsTenTimesAsFastAsTheRunGoesIsNone() throws Exception {
        Window ordinary = window(0, 1);

        assertThat(ordinary(List.of(ordinary, window(50, 10)))).containsExactly(ordinary);
    }

    @Test
    void allCountWhereNoneIsOrdinary() throws Exception {
        List<Window> all = List.of(window(0, 10), window(50, 12));

        assertThat(ordinary(all)).isEqualTo(all);
    }
}
