package org.auvsim.viz.scene;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class CountedTest {
    @Test
    void oneIsOne() {
        assertThat(Counted.of(0, "frame")).isEqualTo("0 frames");
        assertThat(Counted.of(1, "frame")).isEqualTo("1 frame");
        assertThat(Counted.of(2, "frame")).isEqualTo("2 frames");
    }
}
