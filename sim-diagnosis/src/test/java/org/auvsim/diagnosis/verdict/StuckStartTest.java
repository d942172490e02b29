package org.auvsim.diagnosis.verdict;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Hypothesis;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.search.Search;
import org.auvsim.diagnosis.search.Way;
import org.auvsim.diagnosis.subject.Catamaran;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;

/**
 * Runs of a model that is right, whose start is not stated and hardly seen: fitted from windows
 * that follow the noise, it spins at first by a hundred radians a second, or goes as many metres.
 */
class StuckStartTest {
    @ParameterizedTest(name = "seed {0}")
    @ValueSource(longs = {23, 32, 45})
    void aRightModelLeavesNothingButNoise(long seed) throws Exception {
        BelievedModel model = Catamaran.believed();
        List<MeasuredRun> runs = List.of(Catamaran.run(seed));

        Search.Found found =
                new Search(model, runs, List.of(), Way.THOROUGH, new Course(Progress.SILENT))
                        .found();

        assertThat(found.none().isWhite()).isTrue();
        assertThat(
                        new Trial(found.stepping(), runs, found.noise())
                                .prediction(Hypothesis.NONE)
                                .isWhite())
                .isTrue();
    }
}
