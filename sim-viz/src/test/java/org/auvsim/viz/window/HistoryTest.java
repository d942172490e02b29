package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.viz.scene.Movement;
import org.junit.jupiter.api.Test;

class HistoryTest {
    private final History history = new History();

    @Test
    void keepsTheLastMinuteAlone() {
        for (int i = 0; i <= 1000; i++) {
            add(i * 0.5);
        }
        assertThat(history.times()).hasSize(121).startsWith(440).endsWith(500);
        assertThat(history.values(2)).startsWith(-440).endsWith(-500);
        assertThat(history.values(3)).endsWith(500);
    }

    @Test
    void neverHoldsMoreThanItHasRoomFor() {
        for (int i = 0; i < 100_000; i++) {
            add(i * 1e-3);
        }
        assertThat(history.times()).hasSizeLessThanOrEqualTo(600).hasSizeGreaterThan(500);
    }

    @Test
    void beginsAnewWhenTimeGoesBack() {
        add(10);
        add(11);
        add(3);
        assertThat(history.times()).containsExactly(3);
    }

    @Test
    void anglesAreAsPeopleSayThem() {
        Quat yaw = Quat.ofAxisAngle(new Vec3(0, 0, 1), 0.5);
        Quat bowUp = Quat.ofAxisAngle(new Vec3(0, 1, 0), -0.2);
        double[] angles = Angles.rollPitchYaw(yaw.times(bowUp));
        assertThat(angles[0]).isCloseTo(0, within(1e-12));
        assertThat(angles[1]).isCloseTo(0.2, within(1e-12));
        assertThat(angles[2]).isCloseTo(0.5, within(1e-12));
    }

    private void add(double time) {
        history.add(
                time,
                new Movement(time, new Vec3(0, 0, -time), Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO));
    }
}
