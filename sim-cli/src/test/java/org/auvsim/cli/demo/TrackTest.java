package org.auvsim.cli.demo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.math.Vec3;
import org.junit.jupiter.api.Test;

class TrackTest {
    @Test
    void errorsAreTakenWhereNoFeedbackCame() {
        Track track = new Track("test");
        track.add(sample(0.1, 3, false));
        track.add(sample(0.2, 1000, true));
        track.add(sample(0.3, 4, false));

        assertThat(track.rmsError()).isEqualTo(Math.sqrt(12.5), within(1e-12));
        assertThat(track.largestError()).isEqualTo(4);
        assertThat(track.corrections()).isEqualTo(1);
    }

    private static Track.Sample sample(double time, double error, boolean corrected) {
        return new Track.Sample(time, Vec3.ZERO, new Vec3(0, error, 0), corrected);
    }
}
