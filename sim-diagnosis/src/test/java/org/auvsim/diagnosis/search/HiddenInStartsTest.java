package org.auvsim.diagnosis.search;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.diagnosis.TwinScrew;
import org.auvsim.diagnosis.cause.Cause;
import org.auvsim.diagnosis.cause.Library;
import org.auvsim.diagnosis.fit.Course;
import org.auvsim.diagnosis.fit.Progress;
import org.auvsim.diagnosis.model.BelievedModel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;

/** A heading that is off by more than a radian, of which windows that follow it show little. */
@Tag("whole-search")
class HiddenInStartsTest {
    /** Where they promise too little it was found after sets of two to five causes. */
    @Test
    void isFoundAmongSingleCauses() throws Exception {
        TwinScrew vehicle =
                TwinScrew.SOUND.steering(heading -> heading + 1.2).measured(200, 1, 0.06);
        BelievedModel model = TwinScrew.model();
        List<MeasuredRun> runs = List.of(vehicle.run(2), vehicle.run(102));
        List<Cause> common =
                Library.of(model, runs).stream()
                        .filter(cause -> !cause.isGeneric())
                        .filter(cause -> cause.guesses(runs).size() <= 2)
                        .toList();

        Search.Found found =
                new Search(model, runs, common, Way.THOROUGH, new Course(Progress.SILENT)).found();

        assertThat(found.best().isWhite()).isTrue();
        assertThat(found.best().fit().hypothesis().causes())
                .extracting(Cause::id)
                .containsExactly("sensor_bias");
        assertThat(found.judged())
                .allSatisfy(
                        set -> assertThat(set.fit().hypothesis().causes().size()).isLessThan(2));
    }
}
