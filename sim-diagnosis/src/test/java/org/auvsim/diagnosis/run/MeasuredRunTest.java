package org.auvsim.diagnosis.run;

import static org.assertj.core.api.Assertions.assertThat;

import org.auvsim.auvsml.run.LastingError;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MeasuredRunTest {
    private static final LastingError DRIFT = new LastingError(0.5, 5);

    private static MeasuredRunBuilder builder() {
        return MeasuredRun.named("run")
                .lastingError(Channel.POSITION, 0, DRIFT)
                .at(0)
                .position(0, 0, 0)
                .at(1)
                .position(1, 0, 0)
                .at(3)
                .position(2, 0, 0);
    }

    @Test
    void whatABuilderIsToldLaterChangesNoRun() {
        MeasuredRunBuilder builder = builder();
        MeasuredRun run = builder.build();

        builder.lastingError(Channel.POSITION, 0, DRIFT).lastingError(Channel.POSITION, 1, DRIFT);

        assertThat(run.lastingErrors(Channel.POSITION, 0)).containsExactly(DRIFT);
        assertThat(run.lastingErrors(Channel.POSITION, 1)).isEmpty();
        assertThat(builder.build().lastingErrors(Channel.POSITION, 0)).hasSize(2);
    }

    @Test
    void partsErrAsLastinglyAsTheWhole() {
        assertThat(builder().build().part("part", 0, 1).lastingErrors(Channel.POSITION, 0))
                .containsExactly(DRIFT);
    }

    @ParameterizedTest
    @CsvSource({"-1, 0", "0, 0", "0.9, 0", "1, 1", "2.9, 1", "3, 2", "9, 2"})
    void aTimeHasTheSampleBefore(double time, int sample) {
        assertThat(builder().build().sampleAt(time)).isEqualTo(sample);
    }

    @Test
    void whatItGoesThroughIsThatOfWhatWasMeasured() {
        MeasuredRun run =
                MeasuredRun.named("run")
                        .at(0)
                        .position(1, -2, Double.NaN)
                        .at(1)
                        .position(Double.NaN, 3, Double.NaN)
                        .at(2)
                        .position(1.5, 0, Double.NaN)
                        .build();

        assertThat(run.range(Channel.POSITION, 0)).isEqualTo(0.5);
        assertThat(run.range(Channel.POSITION, 2)).isZero();
        assertThat(run.range(Channel.POSITION)).isEqualTo(5);
        assertThat(run.range(Channel.VELOCITY)).isZero();
    }
}
