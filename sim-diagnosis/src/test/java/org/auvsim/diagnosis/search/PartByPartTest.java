package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.subject.MeasuredTorpedo;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;

/** A torpedo whose rudder has lost a quarter of its area, in parts of its runs of 40 s. */
class PartByPartTest {
    @Test
    void whatExplainsThePartsIsToldWithTheirLength() throws Exception {
        BelievedModel model = MeasuredTorpedo.model(MeasuredTorpedo.RUDDER);

        assertThat(notice(model, "clock_offset", "fin_gain"))
                .contains(
                        "in parts of 10 s, each with a start of its own, the runs are explained by"
                                + " fin_gain (rudder): over whole runs errors of the start grow too"
                                + " much; cut them into such parts (--parts 10)");
    }

    /** Where the model alone explains the parts, no cause is needed for it. */
    @Test
    void aModelThatLacksNothingNeedsNoCause() throws Exception {
        assertThat(notice(MeasuredTorpedo.model(MeasuredTorpedo.WORN), "fin_gain")).isEmpty();
    }

    private static Optional<String> notice(BelievedModel model, String... ids) throws Exception {
        BelievedModel worn = MeasuredTorpedo.model(MeasuredTorpedo.WORN);
        List<MeasuredRun> runs = List.of(MeasuredTorpedo.run(worn, 1, 0.3, Vec3.ZERO));
        Noise noise = Noise.of(runs);
        List<Hypothesis> causes =
                List.of(ids).stream().map(id -> alone(named(id, model, runs))).toList();
        return new PartByPart(
                        Stepping.longer(model).getFirst(),
                        Misses.of(runs, noise),
                        noise,
                        Course.UNHEARD)
                .notice(causes);
    }

    private static Cause named(String id, BelievedModel model, List<MeasuredRun> runs) {
        return Library.of(model, runs).stream()
                .filter(cause -> cause.id().equals(id))
                .findFirst()
                .orElseThrow();
    }

    private static Hypothesis alone(Cause cause) {
        return Hypothesis.NONE.and(cause, new double[cause.parameters().size()]);
    }
}
