package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Fit;
import org.auvsim.diagnosis.fit.Following;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Judged;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.residual.Misses;
import org.auvsim.diagnosis.residual.Noise;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.shooting.Stepping;
import org.auvsim.diagnosis.subject.MeasuredVehicle;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

import java.util.List;

class TriedTest {
    private Fit believed;
    private List<Cause> library;
    private Tried tried;

    @BeforeEach
    void nothingWasTriedYet() throws Exception {
        BelievedModel model = MeasuredVehicle.model(0.05);
        List<MeasuredRun> runs = List.of(MeasuredVehicle.run(model));
        Noise noise = Noise.of(runs);
        believed =
                Following.of(Stepping.exact(model), Hypothesis.NONE, Misses.of(runs, noise), noise);
        library = Library.of(model, runs);
        tried = new Tried(Judged.of(believed.whole()), noise, Course.UNHEARD);
    }

    private Judged clockOffBy(double offset) {
        Cause clock =
                library.stream()
                        .filter(c -> c.id().equals("clock_offset"))
                        .findFirst()
                        .orElseThrow();
        Hypothesis off = Hypothesis.NONE.and(clock, new double[] {offset});
        return Judged.of(believed.whole().with(off, believed.whole().windows()));
    }

    @Test
    void aClockThatIsOffIsALateSensorToo() {
        Judged clock = clockOffBy(0.2);
        tried.underSpecificNames(clock, library);

        assertThat(tried.eachSetOnce())
                .filteredOn(judged -> judged.score() == clock.score())
                .singleElement()
                .satisfies(
                        judged -> {
                            Hypothesis of = judged.fit().hypothesis();
                            assertThat(of.causes())
                                    .extracting(Cause::id)
                                    .containsExactly("sensor_delay");
                            assertThat(of.numbers()).containsExactly(0.2);
                        });
    }

    /** No sensor tells what is not yet. */
    @Test
    void aClockThatIsAheadIsNoLateSensor() {
        tried.underSpecificNames(clockOffBy(-0.2), library);

        assertThat(tried.eachSetOnce()).hasSize(1);
    }
}
