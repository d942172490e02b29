package org.auvsim.core.effect;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Effects whose force comes, goes or turns round within moments say so. */
class AbruptTest {
    /** It turns round as soon as the body does; what only slows down does not. */
    @Test
    void ofPivotsOnlyDryFrictionIs() {
        assertThat(new PivotFriction(0.1, 0, 0.01).isAbrupt()).isTrue();
        assertThat(new PivotFriction(0, 0.1, 0.01).isAbrupt()).isFalse();
    }

    @Test
    void dryFrictionOfWhatSlidesIs() {
        assertThat(new CoulombFriction(0.1, 9.8, 0.01).isAbrupt()).isTrue();
        assertThat(new CoulombFriction(0, 9.8, 0.01).isAbrupt()).isFalse();
    }
}
