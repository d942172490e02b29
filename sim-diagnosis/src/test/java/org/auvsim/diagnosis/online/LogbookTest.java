package org.auvsim.diagnosis.online;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.auvsim.core.entity.Frame;
import org.auvsim.core.entity.NamedForce;
import org.auvsim.core.math.Vec3;
import org.auvsim.diagnosis.run.Channel;
import org.auvsim.diagnosis.run.MeasuredRun;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.stream.IntStream;

/** What is remembered of an object, and for how long it was measured. */
class LogbookTest {
    private static final int LEAST = 24;

    private final Logbook logbook = new Logbook(100);

    private void measure(int from, int to) {
        for (int second = from; second < to; second++) {
            logbook.add(Heard.measured(second));
        }
    }

    private static List<Double> levels(MeasuredRun run) {
        return IntStream.range(0, run.size())
                .mapToObj(k -> run.commands().getFirst().level(k))
                .toList();
    }

    @Test
    void timeIsNewFromOneMeasurementToTheNext() {
        measure(0, 31);
        assertThat(logbook.newTime()).isEqualTo(30);

        logbook.read();
        assertThat(logbook.newTime()).isZero();

        measure(31, 33);
        assertThat(logbook.newTime()).isEqualTo(2);
    }

    @Test
    void commandsBetweenMeasurementsTakeNoNewTimeAway() {
        for (int tenth = 0; tenth <= 300; tenth++) {
            logbook.add(Heard.told(0.1 * tenth, tenth % 2));
            if (tenth % 10 == 0) {
                logbook.add(Heard.measured(0.1 * tenth));
            }
        }

        assertThat(logbook.newTime()).isCloseTo(30, within(1e-9));
    }

    @Test
    void commandsAloneAreNoNewTime() {
        logbook.add(Heard.told(0, 1));
        logbook.add(Heard.told(10, 0));
        logbook.add(Heard.measured(20));
        logbook.add(Heard.told(30, 1));

        assertThat(logbook.newTime()).isZero();
    }

    @Test
    void whatIsMeasuredLateIsNotNew() {
        measure(0, 11);

        logbook.add(Heard.measured(4.5));
        logbook.add(Heard.measured(11));

        assertThat(logbook.newTime()).isEqualTo(11);
    }

    @Test
    void noTimeIsNewFromBeforeABreakToAfterIt() {
        measure(0, 11);
        logbook.add(new Observation.Broken());
        measure(1000, 1006);
        logbook.add(new Observation.Broken());
        measure(0, 3);

        assertThat(logbook.newTime()).isEqualTo(10 + 5 + 2);
    }

    @Test
    void aBreakBeginsANewRun() {
        measure(0, LEAST);
        logbook.add(new Observation.Broken());
        logbook.add(Heard.told(5, 1));
        measure(5, 5 + LEAST - 1);
        assertThat(logbook.runs()).extracting(MeasuredRun::size).containsExactly(LEAST);

        measure(5 + LEAST - 1, 5 + LEAST);
        assertThat(logbook.runs()).extracting(MeasuredRun::size).containsExactly(LEAST, LEAST);
        assertThat(levels(logbook.runs().getLast())).containsOnly(1.0);
    }

    @Test
    void aCommandHoldsUntilTheNext() {
        logbook.add(Heard.told(0, 0.5));
        measure(1, 13);
        logbook.add(Heard.told(12, 1));
        measure(13, 1 + LEAST);

        List<Double> levels = levels(logbook.runs().getFirst());

        assertThat(levels.subList(0, 11)).containsOnly(0.5);
        assertThat(levels.subList(11, LEAST)).containsOnly(1.0);
    }

    @Test
    void theOldestMakeRoom() {
        measure(0, 150);

        MeasuredRun run = logbook.runs().getFirst();
        assertThat(run.size()).isEqualTo(100);
        assertThat(run.time(0)).isEqualTo(50);
    }

    @Test
    void forcesAreKnownOnceTheyHaveActed() {
        NamedForce push = NamedForce.direct("push", Frame.WORLD, new Vec3(2, 0, 0));

        logbook.add(Heard.pushed(0, push));
        logbook.add(Heard.told(1, 0));

        assertThat(logbook.forces()).containsExactly(push);
    }

    @Test
    void eachAxisIsAsSureAsItsVarianceSays() {
        double[] deviations = {1, 2, 0.01, 0.1, 0.2, 0.001, 3, 4, 5, 6, 7, 8};
        for (int second = 0; second < LEAST; second++) {
            logbook.add(Heard.measured(second, deviations));
        }

        MeasuredRun run = logbook.runs().getFirst();
        int of = 0;
        for (Channel channel : Channel.values()) {
            for (int axis = 0; axis < 3; axis++) {
                assertThat(run.deviation(channel, 5, axis))
                        .as("%s %s", channel, axis)
                        .isCloseTo(deviations[of], within(1e-12));
                of++;
            }
        }
    }

    @Test
    void whatOneMessageOfAStepLacksAnotherHas() {
        for (int second = 0; second < LEAST; second++) {
            logbook.add(Heard.placed(second, new Vec3(second, 0, 0), 0.5));
            logbook.add(Heard.turning(second, new Vec3(0, 0, 0.1), 0.02));
            logbook.add(Heard.placed(second, new Vec3(second, 1, 0), 0.3));
        }

        MeasuredRun run = logbook.runs().getFirst();
        assertThat(run.size()).isEqualTo(LEAST);
        assertThat(run.value(Channel.POSITION, 5, 1)).isEqualTo(1);
        assertThat(run.deviation(Channel.POSITION, 5, 1)).isCloseTo(0.3, within(1e-12));
        assertThat(run.value(Channel.ANGULAR_VELOCITY, 5, 2)).isEqualTo(0.1);
        assertThat(run.deviation(Channel.ANGULAR_VELOCITY, 5, 2)).isCloseTo(0.02, within(1e-12));
        assertThat(run.value(Channel.VELOCITY, 5, 0)).isNaN();
    }
}
