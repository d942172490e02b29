package org.auvsim.diagnosis.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.auvsim.core.math.Quat;
import org.auvsim.core.math.Vec3;
import org.auvsim.server.feedback.RigidMotion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;

class SplitTest {
    private static MeasuredRun run(String name, int samples) {
        MeasuredRunBuilder run = MeasuredRun.named(name);
        for (int i = 0; i < samples; i++) {
            run.at(i).position(i, 0, 0);
        }
        return run.build();
    }

    @ParameterizedTest
    @CsvSource({"2,1", "3,2", "4,3", "5,1 4", "6,2 5", "9,2 5 8"})
    void aThirdOfTheRunsIsHeldOut(int count, String expected) {
        List<MeasuredRun> runs =
                IntStream.range(0, count).mapToObj(i -> run(Integer.toString(i), 20)).toList();

        Split split = Split.of(runs);

        assertThat(split.heldOut())
                .extracting(MeasuredRun::name)
                .containsExactly(expected.split(" "));
        assertThat(split.fit()).hasSize(count - split.heldOut().size());
        assertThat(split.fit()).doesNotContainAnyElementsOf(split.heldOut());
        assertThat(split.notice()).contains(String.join(", ", expected.split(" ")));
    }

    @Test
    void ofOneRunTheTimeIsSplit() {
        Split split = Split.of(List.of(run("dive", 120)));

        assertThat(split.fit()).extracting(MeasuredRun::name).containsExactly("dive-1", "dive-3");
        assertThat(split.heldOut())
                .extracting(MeasuredRun::name)
                .containsExactly("dive-2", "dive-4");
        assertThat(split.fit()).extracting(MeasuredRun::size).containsExactly(40, 40);
        assertThat(split.heldOut()).extracting(r -> r.time(0)).containsExactly(40.0, 100.0);
        assertThat(split.notice())
                .isEqualTo(
                        "there is one run: its time is split, 40 to 59 s and 100 to 119 s held"
                                + " out");
    }

    /** As UNIX time has it. */
    @Test
    void whatBeginsFarFromZeroIsToldFromItsFirstRow() {
        MeasuredRunBuilder run = MeasuredRun.named("dive");
        for (int i = 0; i < 120; i++) {
            run.at(1_718_000_000 + 0.5 * i).position(i, 0, 0);
        }

        assertThat(Split.of(List.of(run.build())).notice())
                .isEqualTo(
                        "there is one run: its time is split, 20 to 29.5 s and 50 to 59.5 s"
                                + " held out (from its first row)");
    }

    /** Else only the first of two blocks would be seen to begin where it is known to. */
    @Test
    void aRunWhoseStartIsKnownIsSplitOnce() {
        MeasuredRunBuilder run = MeasuredRun.named("dive");
        for (int i = 0; i < 120; i++) {
            run.at(i).position(i, 0, 0);
        }
        run.start(
                new KnownStart(
                        new RigidMotion(Vec3.ZERO, Quat.IDENTITY, Vec3.ZERO, Vec3.ZERO),
                        Collections.nCopies(RigidMotion.SIZE, 0.1)));

        Split split = Split.of(List.of(run.build()));

        assertThat(split.fit()).extracting(MeasuredRun::size).containsExactly(80);
        assertThat(split.fit().getFirst().start()).isPresent();
        assertThat(split.heldOut()).extracting(MeasuredRun::size).containsExactly(40);
        assertThat(split.heldOut().getFirst().start()).isEmpty();
    }

    @Test
    void aShortRunIsSplitOnce() {
        Split split = Split.of(List.of(run("drop", 60)));

        assertThat(split.fit()).extracting(MeasuredRun::size).containsExactly(40);
        assertThat(split.heldOut()).extracting(MeasuredRun::size).containsExactly(20);
    }

    @Test
    void aRunCanBeTooShortToSplit() {
        assertThatThrownBy(() -> Split.of(List.of(run("drop", 40))))
                .hasMessage(
                        "run 'drop' has 40 samples; expected 48 to fit two thirds and hold out"
                                + " one: give a longer run, or another one to hold out");
    }
}
