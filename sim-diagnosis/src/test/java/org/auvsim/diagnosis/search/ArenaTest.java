package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Parameter;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Knowledge;
import org.auvsim.diagnosis.model.Variant;
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

/** Where variants compete, a cause costs what it costs in every other search. */
class ArenaTest {
    private static final int SAMPLES = 50;

    /** As one of a few that were chosen is cheaper. */
    private static final class Cheap implements Cause {
        @Override
        public String id() {
            return "cheap";
        }

        @Override
        public List<Parameter> parameters() {
            return List.of(Parameter.signed("a", "1", 1));
        }

        @Override
        public Variant in(Variant model, double[] theta) {
            return model;
        }

        @Override
        public double price(int measured, double independent) {
            return 3 + 0.01 * measured;
        }
    }

    private static MeasuredRun run() {
        MeasuredRunBuilder run = MeasuredRun.named("still");
        for (int k = 0; k < SAMPLES; k++) {
            run.at(0.1 * k).position(0.01 * (k % 2), 0.01 * (k % 3), Double.NaN);
        }
        return run.build();
    }

    @Test
    void aCauseCostsWhatItSays() throws Exception {
        MeasuredRun run = run();
        RigidMotion still = new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO);
        Fit fit =
                new Fit(
                        Stepping.exact(FreeSphere.believed(0.1)),
                        List.of(new Misses(run, Noise.of(List.of(run)))),
                        Hypothesis.NONE,
                        List.of(List.of(new Window(0, SAMPLES - 1, still))),
                        Knowledge.NONE);
        Arena arena = new Arena(fit, Course.UNHEARD);
        Cause cheap = new Cheap();

        Arena.Candidate two =
                new Arena.Candidate(
                        List.of(cheap, new Cheap()), List.of(new double[1], new double[1]));

        assertThat(arena.count()).isEqualTo(2 * SAMPLES);
        assertThat(arena.price(two)).isEqualTo(8);
    }
}
