package org.auvsim.diagnosis.fit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

class CourseTest {
    private final List<Double> told = new ArrayList<>();
    private boolean goesOn = true;

    private final Course course =
            new Course(
                    (stage, share) -> {
                        told.add(share);
                        return goesOn;
                    });

    @Test
    void itNeverGoesBack() {
        course.at("fitting", 0.5);
        course.at("fitting", 0.3);

        assertThat(told).containsExactly(0.5, 0.5);
    }

    @Test
    void aSearchInAdditionHasAShareOfTheWay() {
        course.at("judging", 0.9);
        Course more = course.more(0.98);
        more.at("following", 0);
        more.at("screening", 0.5);
        more.at("fitting", 1);

        assertThat(told.get(1)).isCloseTo(0.9, within(1e-12));
        assertThat(told.get(2)).isCloseTo(0.94, within(1e-12));
        assertThat(told.get(3)).isCloseTo(0.98, within(1e-12));
    }

    @Test
    void whoStopsItStopsWhatIsInAddition() {
        Course more = course.more(1);
        goesOn = false;

        assertThat(more.at("following", 0.1)).isFalse();
        assertThat(course.goesOn()).isFalse();
        assertThat(more.goesOn()).isFalse();
    }
}
