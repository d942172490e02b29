package org.auvsim.diagnosis.shaking;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.diagnosis.run.MeasuredRun;
import org.auvsim.diagnosis.run.MeasuredRunBuilder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

class SoundRunsTest {
    private static final Rotor SOUND = new Rotor(0.01, 0.05);
    private static final int ROWS = 150;

    private static List<MeasuredRun> runs(Rotor rotor, long firstSeed, int count) {
        List<MeasuredRun> runs = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            runs.add(rotor.run(firstSeed + i, ROWS, 0.5));
        }
        return runs;
    }

    private static Shaking compared(List<MeasuredRun> sound, List<MeasuredRun> others) {
        return SoundRuns.of(Rotor.MODEL, sound).compared(others).orElseThrow();
    }

    /** Of a table of Student's distribution: one-sided, 1 %, 7 degrees of freedom. */
    private static final double OF_EIGHT = 2.998;

    @ParameterizedTest(name = "{0} runs")
    @ValueSource(ints = {1, 3})
    void theLimitIsThatOfStudentsDistribution(int count) {
        List<MeasuredRun> sound = runs(SOUND, 1, 8);
        double[] strengths =
                sound.stream()
                        .mapToDouble(run -> Shake.of(run, Rotor.MODEL).orElseThrow().strength())
                        .toArray();
        double mean = Arrays.stream(strengths).average().orElseThrow();
        double square = Arrays.stream(strengths).map(s -> (s - mean) * (s - mean)).sum() / 7;

        Shaking shaking = compared(sound, runs(SOUND, 100, count));

        assertThat(shaking.limit())
                .isCloseTo(
                        1 + OF_EIGHT * Math.sqrt(square * (1.0 / count + 1.0 / 8)) / mean,
                        within(1e-3));
        assertThat(shaking.references()).isEqualTo(8);
        assertThat(shaking.runs()).isEqualTo(count);
    }

    /** An imbalance that is twice as large shakes four times as much. */
    @Test
    void anImbalanceIsMore() {
        Shaking shaking = compared(runs(SOUND, 1, 8), runs(new Rotor(0.02, 0.05), 100, 4));

        assertThat(shaking.isTooMuch()).isTrue();
        assertThat(shaking.factor()).isCloseTo(4, within(3 * shaking.deviation()));
        assertThat(shaking.logEvidence()).isPositive();
    }

    /** One in a hundred is an alarm, as chance makes them. */
    @Test
    void soundRunsRaiseFewAlarms() {
        int alarms = 0;
        for (int i = 0; i < 500; i++) {
            List<MeasuredRun> all = runs(SOUND, 1000L + 9L * i, 9);
            alarms += compared(all.subList(0, 8), all.subList(8, 9)).isTooMuch() ? 1 : 0;
        }

        assertThat(alarms).isLessThanOrEqualTo(15);
    }

    @Test
    void howASensorIsMountedDoesNotMatter() {
        List<MeasuredRun> sound = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            sound.add(SOUND.run(1 + i, ROWS, k -> 0.5, k -> 0, -1));
        }
        MeasuredRun other = new Rotor(0, 0).run(9, ROWS, k -> 0.5, k -> 0, -1);

        assertThat(compared(sound, List.of(other)).factor()).isCloseTo(0, within(1e-12));
        assertThat(
                        compared(
                                        sound,
                                        List.of(
                                                new Rotor(0.03, 0)
                                                        .run(9, ROWS, k -> 0.5, k -> 0, -1)))
                                .isTooMuch())
                .isTrue();
    }

    /** The reference is all of a run, and so is what is compared with it. */
    @Test
    void partsCountAsTheRunThatTheyAreOf() {
        List<MeasuredRun> sound = runs(SOUND, 1, 8);
        List<MeasuredRun> parts =
                sound.stream().map(run -> run.part(run.name() + "-1", 0, 20)).toList();
        MeasuredRun other = SOUND.run(9, ROWS, 0.5);

        assertThat(compared(parts, List.of(other))).isEqualTo(compared(sound, List.of(other)));
    }

    @Test
    void runsThatCannotBeComparedAreNot() {
        SoundRuns sound = SoundRuns.of(Rotor.MODEL, runs(SOUND, 1, 8));
        MeasuredRunBuilder slow = MeasuredRun.named("slow").commands(List.of("main"));
        for (int k = 0; k < ROWS; k++) {
            slow.at(0.1 * k).command(0, 0.5).shaking(k % 3, k % 2);
        }

        assertThat(sound.compared(List.of(slow.build()))).isEmpty();
        assertThat(sound.compared(List.of(SOUND.run(9, ROWS, 0)))).isEmpty();
    }

    @Test
    void aReferenceIsRefusedWithAReason() {
        MeasuredRun silent =
                MeasuredRun.named("silent").at(0).position(0, 0, 0).at(1).position(1, 0, 0).build();

        assertThatThrownBy(() -> SoundRuns.of(Rotor.MODEL, List.of(silent)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage(
                        "run 'silent' tells nothing of shaking; name the columns that do in the"
                                + " mapping, as <shaking acceleration=\"ax\" rate=\"wy\"/>");
        assertThatThrownBy(() -> SoundRuns.of(Rotor.MODEL, runs(SOUND, 1, 1)))
                .hasMessage(
                        "there is 1 reference run; expected two at least, to tell how they"
                                + " scatter");
        assertThatThrownBy(() -> SoundRuns.of(Rotor.MODEL, List.of(SOUND.run(1, ROWS, 0))))
                .hasMessage(
                        "run 'run 1' has too few rows of steady thrust to tell how the body shakes;"
                                + " expected 16 evenly spaced ones");
        assertThatThrownBy(() -> SoundRuns.of(Rotor.MODEL, runs(new Rotor(0, 0), 1, 2)))
                .hasMessage(
                        "nothing shakes the two sensors of the reference runs alike; name two"
                                + " others");
    }
}
