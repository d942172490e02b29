package org.auvsim.viz.driving;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import java.util.Optional;

class SticksTest {
    @Test
    void sticksAskForTheirDirections() {
        Gamepad gamepad = () -> Optional.of(new Sticks(-1, -1, 1, 1, 0, 1));
        assertThat(gamepad.poll().map(Sticks::wanted)).contains(new Wanted(1, -1, -1, 1, 1));
    }

    @Test
    void nearTheMiddleTheyAskForNothing() {
        assertThat(new Sticks(0.09, -0.1, 0.05, -0.02, 0.1, 0.05).wanted().surge()).isZero();
        assertThat(new Sticks(0.1, 0, 0, 0, 0, 0).wanted().yaw()).isZero();
    }

    @Test
    void beyondTheDeadZoneTheyBeginAtNothing() {
        assertThat(new Sticks(0, -0.101, 0, 0, 0, 0).wanted().surge())
                .isCloseTo(0.001, within(1e-3));
        assertThat(new Sticks(0, -0.55, 0, 0, 0, 0).wanted().surge()).isCloseTo(0.5, within(1e-9));
    }

    @Test
    void keysAndSticksTogetherStayWithinOne() {
        Wanted full = new Wanted(1, 0, -1, 0, 0);
        assertThat(full.plus(full)).isEqualTo(full);
    }
}
