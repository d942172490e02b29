package org.auvsim.viz.window;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.viz.driving.Wanted;
import org.junit.jupiter.api.Test;

import java.awt.event.KeyEvent;

class HeldKeysTest {
    private final HeldKeys keys = new HeldKeys();

    @Test
    void keysAskForTheirDirections() {
        keys.press(KeyEvent.VK_W);
        keys.press(KeyEvent.VK_D);
        keys.press(KeyEvent.VK_Q);
        keys.press(KeyEvent.VK_F);
        keys.press(KeyEvent.VK_UP);
        assertThat(keys.wanted()).isEqualTo(new Wanted(1, 1, -1, -1, 1));
    }

    @Test
    void aKeyLetGoAsksNoMore() {
        keys.press(KeyEvent.VK_W);
        keys.release(KeyEvent.VK_W);
        keys.settle();
        assertThat(keys.wanted()).isEqualTo(Wanted.NOTHING);
    }

    @Test
    void aKeyThatRepeatsStaysHeld() {
        keys.press(KeyEvent.VK_W);
        keys.release(KeyEvent.VK_W);
        keys.press(KeyEvent.VK_W);
        keys.settle();
        assertThat(keys.wanted().surge()).isEqualTo(1);
    }

    @Test
    void oppositeKeysAskForNothing() {
        keys.press(KeyEvent.VK_A);
        keys.press(KeyEvent.VK_RIGHT);
        assertThat(keys.wanted().yaw()).isZero();
    }
}
