package org.auvsim.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Mat3;
import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;

class RecordedBodyTest {
    private final RecordedBody body = new RecordedBody();

    @Test
    void aBodyThatRestsIsWhereItWasAfterEachStep() {
        body.moved(0, 0, at(0, 1));
        body.moved(0, 4, at(0.4, 2));
        body.rests(6, 0.6);

        assertThat(body.until(1))
                .map(pose -> pose.position().x())
                .containsExactly(1d, 1d, 1d, 1d, 2d, 2d, 2d);
        assertThat(body.until(1).get(3).time()).isCloseTo(0.3, within(1e-12));
        assertThat(body.until(1).get(5).time()).isCloseTo(0.5, within(1e-12));
        assertThat(body.until(0.35)).hasSize(4);
    }

    @Test
    void aBodyThatLeavesIsSeenUpToTheStepBefore() {
        body.moved(0, 0, at(0, 1));
        body.left(3, 0.3);
        body.rests(9, 0.9);

        assertThat(body.until(1)).hasSize(3);
        assertThat(body.until(1).getLast().time()).isCloseTo(0.2, within(1e-12));
    }

    @Test
    void whereTimeGoesBackWhatWasLaterIsForgotten() {
        body.moved(0, 0, at(0, 1));
        body.moved(0, 1, at(0.1, 2));
        body.moved(0, 2, at(0.2, 3));
        body.moved(1, 3, at(0.1, 7));

        assertThat(body.until(1)).map(pose -> pose.position().x()).containsExactly(1d, 7d);
    }

    private static Pose at(double time, double x) {
        return new Pose(time, new Vec3(x, 0, 0), Mat3.IDENTITY);
    }
}
