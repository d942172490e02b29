package org.auvsim.core.math;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class SplitMix64Test {
    /** The first outputs from the state 1234567, as the authors' C code prints them. */
    @Test
    void itsOutputsAreThePublishedOnes() {
        String[] outputs = {
            "6457827717110365317",
            "3203168211198807973",
            "9817491932198370423",
            "4593380528125082431",
            "16408922859458223821"
        };
        long state = 1234567;
        for (String output : outputs) {
            state += SplitMix64.STEP;
            assertThat(Long.toUnsignedString(SplitMix64.mix(state))).isEqualTo(output);
        }
    }

    @Test
    void aUnitNumberIsBelowOne() {
        assertThat(SplitMix64.unit(0)).isZero();
        assertThat(SplitMix64.unit(-1)).isEqualTo(Math.nextDown(1.0));
        assertThat(SplitMix64.unit(1L << 63)).isEqualTo(0.5);
    }
}
